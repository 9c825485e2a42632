/** The separate bodies of a mesh. */
import { Groups } from './groups.js';

/** A body: faces that hang together. */
export interface Component {
  faces: number;
  /** The longest side of its bounding box, in units of the mesh. */
  longestSide: number;
}

export interface Components {
  /** In the order of their first faces. */
  components: Component[];
  /** Per face: the component that it belongs to, from 0. */
  ofFaces: Int32Array;
}

/** A body whose longest side is less than this share of the model's is a crumb or a screw, not a part to build. */
const tinyShare = 0.03;

/** Bounding boxes of groups of points as they grow. */
class Boxes {
  private readonly low: Float64Array;
  private readonly high: Float64Array;

  constructor(count: number) {
    this.low = new Float64Array(3 * count).fill(Infinity);
    this.high = new Float64Array(3 * count).fill(-Infinity);
  }

  /** Takes a vertex into a box. */
  add(box: number, vertices: Float32Array | Float64Array, vertex: number): void {
    for (let axis = 0; axis < 3; ++axis) {
      const value = vertices[3 * vertex + axis]!;
      const at = 3 * box + axis;
      if (value < this.low[at]!) this.low[at] = value;
      if (value > this.high[at]!) this.high[at] = value;
    }
  }

  longestSide(box: number): number {
    const sides = [0, 1, 2].map((axis) => this.high[3 * box + axis]! - this.low[3 * box + axis]!);
    return Math.max(...sides);
  }
}

/** Faces or vertices that are looked at between two pauses: about a millisecond of work. */
const perPause = 1 << 14;

/**
 * Finds the faces that hang together by their vertices, which in a repaired mesh is the same as by their edges.
 * Cost: nearly linear, about 10 ms for 100,000 faces.
 *
 * @param vertices 3 numbers per vertex
 * @param faces 3 vertices per face
 * @param pause is waited for after about every millisecond of work, so that a page stays alive
 */
export async function componentsOf(
  vertices: Float32Array | Float64Array,
  faces: Int32Array,
  pause: () => Promise<void>,
): Promise<Components> {
  const groups = new Groups(vertices.length / 3);
  for (let i = 0; i < faces.length; i += 3) {
    if (i % (3 * perPause) === 0) await pause();
    groups.unite(faces[i]!, faces[i + 1]!);
    groups.unite(faces[i]!, faces[i + 2]!);
  }
  /** By the vertices that stand for groups: 1 more than the number of the component, or 0. */
  const numbers = new Int32Array(vertices.length / 3);
  const faceCounts: number[] = [];
  const ofFaces = new Int32Array(faces.length / 3);
  for (let face = 0; face < ofFaces.length; ++face) {
    if (face % perPause === 0) await pause();
    const root = groups.of(faces[3 * face]!);
    numbers[root] ||= faceCounts.push(0);
    const component = numbers[root] - 1;
    ++faceCounts[component]!;
    ofFaces[face] = component;
  }
  const boxes = new Boxes(faceCounts.length);
  for (let vertex = 0; vertex < numbers.length; ++vertex) {
    if (vertex % perPause === 0) await pause();
    const number = numbers[groups.of(vertex)]!;
    // A vertex without faces is of no body.
    if (number > 0) boxes.add(number - 1, vertices, vertex);
  }
  const components = faceCounts.map((count, component) => ({
    faces: count,
    longestSide: boxes.longestSide(component),
  }));
  return { components, ofFaces };
}

/** Whether a body is tiny in a model whose longest side is given. */
export function isTiny({ longestSide }: Component, modelSide: number): boolean {
  return longestSide < tinyShare * modelSide;
}
