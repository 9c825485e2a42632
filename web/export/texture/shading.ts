/** The light that a surface has by itself, to be printed: folds of cloth are seen where faces are too few to have them. */
import { cornersOf, NearestFace, normalAt } from '../../model/nearest-face.js';
import {
  direction,
  dot,
  length,
  minus,
  plus,
  times,
  vectorAt,
  type Vector,
} from '../../model/vector.js';
import type { Surface } from './surface-look.js';

/** Towards the light: from above, in front (along z) and a little from the left. */
const towardsLight = direction([-0.4, 0.8, 0.6]);
/**
 * What looks away from the light is printed as bright as this. Light fades all the way there, so that shapes are seen
 * on the back, too.
 */
const turnedAway = 0.5;
/** Darker paper would hide lines and numbers. */
const darkest = 0.35;
/** Edges that are bent by more are sharp, those of a box as well; the cosine of 60 degrees. */
const sharp = 0.5;

/** How far from the surface it is looked for what shuts light out, in shares of its size, and how much each tells. */
const gaps = [
  [0.01, 0.5],
  [0.02, 0.3],
  [0.04, 0.2],
] as const;
/** What narrow folds lose of their light at most. */
const mostShut = 0.6;
/** A vertex takes some 30 microseconds for that: of more vertices, folds are told by their light alone. */
const mostVertices = 200_000;

function sizeOf({ vertices }: Surface): number {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < vertices.length; ++i) {
    const axis = i % 3;
    least[axis] = Math.min(least[axis]!, vertices[i]!);
    most[axis] = Math.max(most[axis]!, vertices[i]!);
  }
  return Math.hypot(...least.map((value, axis) => most[axis]! - value));
}

/** The faces around each vertex. */
class Umbrellas {
  /** Per vertex, where its corners begin in `corners`; and the end. */
  private readonly starts: Int32Array;
  private readonly corners: Int32Array;
  /** Per face, as long as twice its area. */
  private readonly normals: Vector[];

  constructor(readonly surface: Surface) {
    const { faces, vertices } = surface;
    this.starts = new Int32Array(vertices.length / 3 + 1);
    for (const vertex of faces) ++this.starts[vertex + 1]!;
    for (let i = 1; i < this.starts.length; ++i) this.starts[i]! += this.starts[i - 1]!;
    const next = this.starts.slice();
    this.corners = new Int32Array(faces.length);
    faces.forEach((vertex, corner) => (this.corners[next[vertex]!++] = corner));
    const all = cornersOf(surface);
    this.normals = Array.from({ length: faces.length / 3 }, (_, face) => normalAt(all, 9 * face));
  }

  /** The mean of the faces around a vertex; of those that go on smoothly from a face, if one is given. */
  normalOf(vertex: number, from: Vector | null): Vector {
    let sum: Vector = [0, 0, 0];
    for (let i = this.starts[vertex]!; i < this.starts[vertex + 1]!; ++i) {
      const normal = this.normals[Math.floor(this.corners[i]! / 3)]!;
      const isSmooth = !from || dot(normal, from) >= sharp * length(normal) * length(from);
      if (isSmooth) sum = plus(sum, normal);
    }
    return direction(sum, from ?? undefined);
  }

  normalAtCorner(corner: number): Vector {
    return this.normalOf(this.surface.faces[corner]!, this.normals[Math.floor(corner / 3)]!);
  }

  /** The mean length of sides. */
  get meanSide(): number {
    const { faces, vertices } = this.surface;
    let sum = 0;
    for (let corner = 0; corner < faces.length; ++corner) {
      const next = corner % 3 === 2 ? corner - 2 : corner + 1;
      sum += length(minus(vectorAt(vertices, faces[corner]!), vectorAt(vertices, faces[next]!)));
    }
    return sum / Math.max(1, faces.length);
  }
}

/** Per vertex how much light reaches it, as what lies nearer than the free space before it shuts out the rest. */
function opennessOf(umbrellas: Umbrellas): Float32Array | null {
  const { surface } = umbrellas;
  const count = surface.vertices.length / 3;
  const size = sizeOf(surface);
  // Between corners that are far apart nothing could be told of what lies between them.
  const isCoarse = umbrellas.meanSide > gaps.at(-1)![0] * size;
  if (count > mostVertices || isCoarse) return null;
  const nearest = new NearestFace(surface);
  const open = new Float32Array(count);
  for (let vertex = 0; vertex < count; ++vertex) {
    const from = vectorAt(surface.vertices, vertex);
    const normal = umbrellas.normalOf(vertex, null);
    let shut = 0;
    for (const [share, weight] of gaps) {
      const reach = share * size;
      const way = nearest.distance(plus(from, times(normal, reach)), reach);
      shut += weight * (1 - way / reach);
    }
    open[vertex] = 1 - mostShut * shut;
  }
  return open;
}

/** How bright each corner of a surface is, y up, in a fixed soft light; three per face, up to 1. */
export function shadesOf(surface: Surface): Float32Array {
  const umbrellas = new Umbrellas(surface);
  const open = opennessOf(umbrellas);
  return Float32Array.from(surface.faces, (vertex, corner) => {
    const facing = dot(umbrellas.normalAtCorner(corner), towardsLight);
    const light = turnedAway + ((1 - turnedAway) * (1 + facing)) / 2;
    return Math.max(darkest, light * (open?.[vertex] ?? 1));
  });
}

/** The brightness of a point of a face at shares of its second and third corner. */
export function shadeAt(shades: Float32Array, face: number, b: number, c: number): number {
  const at = 3 * face;
  return (1 - b - c) * shades[at]! + b * shades[at + 1]! + c * shades[at + 2]!;
}
