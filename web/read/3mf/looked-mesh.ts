import type { Part } from '../soup.js';
import type { CornerLook } from './package-looks.js';
import type { TriangleProperties } from './triangle-properties.js';

type Shape = Pick<Part, 'positions' | 'triangles' | 'looks'>;

/** Triangles whose vertices come apart where corners at them look different. */
class SplitMesh {
  readonly vertices: number[] = [];
  readonly triangles: number[] = [];
  readonly looks: CornerLook[] = [];
  private readonly numbers = new Map<number, number>();

  /** @param count of all vertices before */
  constructor(private readonly count: number) {}

  add(vertex: number, look: CornerLook): void {
    const key = look.key * this.count + vertex;
    let number = this.numbers.get(key);
    if (number === undefined) {
      number = this.vertices.push(vertex) - 1;
      this.looks.push(look);
      this.numbers.set(key, number);
    }
    this.triangles.push(number);
  }
}

/** The three values of each of these vertices or triangles. */
function threesOf(values: readonly number[], chosen: readonly number[]): Float64Array {
  return Float64Array.from(
    { length: 3 * chosen.length },
    (_, i) => values[3 * chosen[Math.floor(i / 3)]! + (i % 3)]!,
  );
}

/** Values of all vertices in a row; null if none has any. */
function inRow<List extends Float32Array | Uint8Array>(
  looks: readonly CornerLook[],
  valuesOf: (look: CornerLook) => ArrayLike<number> | null,
  all: List,
): List | null {
  const each = all.length / looks.length;
  let isEmpty = true;
  looks.forEach((look, i) => {
    const values = valuesOf(look);
    if (!values) return;
    all.set(values, each * i);
    isEmpty = false;
  });
  return isEmpty ? null : all;
}

/**
 * Some triangles of a mesh with how they look; a triangle's material is that of its first corner.
 *
 * @param chosen numbers of the triangles
 * @param lookOf how a corner looks that has a property of a group
 */
export function lookedMesh(
  { positions, triangles }: { positions: readonly number[]; triangles: readonly number[] },
  chosen: readonly number[],
  properties: TriangleProperties,
  lookOf: (group: number, index: number) => CornerLook,
): Shape {
  if (properties.isEmpty) {
    const isWhole = 3 * chosen.length === triangles.length;
    return { positions, triangles: isWhole ? triangles : threesOf(triangles, chosen) };
  }
  const split = new SplitMesh(positions.length / 3);
  const materials = new Int32Array(chosen.length);
  chosen.forEach((triangle, i) => {
    const group = properties.group(triangle);
    for (const corner of [0, 1, 2]) {
      const look = lookOf(group, properties.corner(triangle, corner));
      if (corner === 0) materials[i] = look.material;
      split.add(triangles[3 * triangle + corner]!, look);
    }
  });
  const { vertices, looks } = split;
  return {
    positions: threesOf(positions, vertices),
    triangles: split.triangles,
    looks: {
      places: inRow(looks, ({ place }) => place, new Float32Array(2 * looks.length).fill(NaN)),
      colours: inRow(looks, ({ colour }) => colour, new Uint8Array(3 * looks.length).fill(255)),
      materials: materials.some((material) => material !== -1) ? materials : null,
    },
  };
}
