/** Lays pieces of small models flat, so that exporters can be tested without the engine. */
import type { Piece } from '../../web/model/job.js';
import { cross, dot, length, minus } from './vectors.js';

export type Point = [number, number];

export interface Mesh {
  vertices: number[][];
  faces: number[][];
}

/** The corner of a triangle over a base that is already laid down, on its left. */
function apex(mesh: Mesh, face: number, corner: number, from: Point, to: Point): Point {
  const [a, b, c] = [0, 1, 2].map((i) => mesh.vertices[mesh.faces[face]![(corner + i) % 3]!]!);
  const base = minus(b!, a!);
  const x = dot(minus(c!, a!), base) / dot(base, base);
  const y = length(cross(base, minus(c!, a!))) / dot(base, base);
  const [ex, ey] = [to[0] - from[0], to[1] - from[1]];
  return [from[0] + x * ex - y * ey, from[1] + x * ey + y * ex];
}

function angleBetween(mesh: Mesh, a: number, b: number, from: number, to: number): number {
  const normals = [a, b].map((face) => {
    const [p, q, r] = mesh.faces[face]!.map((vertex) => mesh.vertices[vertex]!);
    return cross(minus(q!, p!), minus(r!, p!));
  });
  const along = minus(mesh.vertices[to]!, mesh.vertices[from]!);
  const sine = dot(cross(normals[0]!, normals[1]!), along) / length(along);
  return (-Math.atan2(sine, dot(normals[0]!, normals[1]!)) * 180) / Math.PI + 0;
}

/** Collects the vertices, edges and faces of one net while its faces are laid down. */
class NetBuilder {
  readonly vertices: Point[] = [];
  readonly corners = new Map<number, number[]>();
  readonly folds: { edge: [number, number]; angle: number; model: number[] }[] = [];

  constructor(private readonly mesh: Mesh) {}

  private add(point: Point): number {
    return this.vertices.push(point) - 1;
  }

  first(face: number): void {
    const [a, b] = this.mesh.faces[face]!.map((vertex) => this.mesh.vertices[vertex]!);
    const [from, to]: Point[] = [
      [0, 0],
      [length(minus(b!, a!)), 0],
    ];
    const third = apex(this.mesh, face, 0, from!, to!);
    this.corners.set(face, [this.add(from!), this.add(to!), this.add(third)]);
  }

  /** Lays `face` beside `parent`, which is laid already. */
  beside(parent: number, face: number): void {
    const [mine, theirs] = [this.mesh.faces[face]!, this.mesh.faces[parent]!];
    const corner = mine.findIndex((vertex, i) => {
      const at = theirs.indexOf(vertex);
      return at >= 0 && theirs[(at + 2) % 3] === mine[(i + 1) % 3];
    });
    const [u, v] = [mine[corner]!, mine[(corner + 1) % 3]!];
    const laid = this.corners.get(parent)!;
    const [from, to] = [laid[theirs.indexOf(u)]!, laid[theirs.indexOf(v)]!];
    const third = apex(this.mesh, face, corner, this.vertices[from]!, this.vertices[to]!);
    const corners: number[] = [];
    corners[corner] = from;
    corners[(corner + 1) % 3] = to;
    corners[(corner + 2) % 3] = this.add(third);
    this.corners.set(face, corners);
    const angle = angleBetween(this.mesh, face, parent, u, v);
    this.folds.push({ edge: [from, to], angle, model: [u, v] });
  }

  /** Turns by `quarter` right angles and moves the lower left of the bounding box to (0, 0). */
  settle(): { width: number; height: number } {
    const low = [0, 1].map((k) => Math.min(...this.vertices.map((p) => p[k]!)));
    const high = [0, 1].map((k) => Math.max(...this.vertices.map((p) => p[k]!)));
    for (const point of this.vertices) {
      point[0] -= low[0]!;
      point[1] -= low[1]!;
    }
    return { width: high[0]! - low[0]!, height: high[1]! - low[1]! };
  }
}

function walkBoundary(next: Map<number, number>): Int32Array[] {
  const walks: Int32Array[] = [];
  while (next.size > 0) {
    const walk: number[] = [];
    let vertex = next.keys().next().value!;
    while (next.has(vertex)) {
      walk.push(vertex);
      const following = next.get(vertex)!;
      next.delete(vertex);
      vertex = following;
    }
    walks.push(Int32Array.from(walk));
  }
  return walks;
}

/** Numbers the edges of a mesh as its faces first name them. */
function edgeNumbers(mesh: Mesh): Map<string, number> {
  const numbers = new Map<string, number>();
  for (const face of mesh.faces) {
    face.forEach((from, i) => {
      const key = [from, face[(i + 1) % 3]!].sort((a, b) => a - b).join();
      if (!numbers.has(key)) numbers.set(key, numbers.size);
    });
  }
  return numbers;
}

/** A piece from a tree: its first face, then pairs of a laid face and the one to lay beside it. */
export function layPiece(mesh: Mesh, first: number, tree: [number, number][]): Piece {
  const net = new NetBuilder(mesh);
  net.first(first);
  for (const [parent, face] of tree) net.beside(parent, face);
  const { width, height } = net.settle();
  const sources = [...net.corners.keys()];
  const numbers = edgeNumbers(mesh);
  const number = (u: number, v: number) => numbers.get([u, v].sort((a, b) => a - b).join())!;
  const folded = new Set(net.folds.map(({ edge }) => [...edge].sort((a, b) => a - b).join()));
  const cuts: { edge: [number, number]; model: number[] }[] = [];
  const next = new Map<number, number>();
  for (const face of sources) {
    const corners = net.corners.get(face)!;
    corners.forEach((from, i) => {
      const to = corners[(i + 1) % 3]!;
      if (folded.has([from, to].sort((a, b) => a - b).join())) return;
      next.set(from, to);
      cuts.push({
        edge: [from, to],
        model: [mesh.faces[face]![i]!, mesh.faces[face]![(i + 1) % 3]!],
      });
    });
  }
  const letter = (angle: number) => (Math.abs(angle) < 1e-3 ? 'F' : angle < 0 ? 'M' : 'V');
  const edges = [...net.folds, ...cuts];
  const foldAngles = [...net.folds.map(({ angle }) => angle), ...cuts.map(() => NaN)];
  return {
    id: 0,
    name: 'A',
    part: 0,
    cause: 'part',
    overlaps: 0,
    width,
    height,
    vertices: Float64Array.from(net.vertices.flat()),
    faces: Int32Array.from(sources.flatMap((face) => net.corners.get(face)!)),
    sources: Int32Array.from(sources),
    edges: Int32Array.from(edges.flatMap(({ edge }) => edge)),
    assignments: net.folds.map(({ angle }) => letter(angle)).join('') + 'B'.repeat(cuts.length),
    foldAngles: Float64Array.from(foldAngles),
    foldable: 'line',
    motion: {
      root: 0,
      times: Float64Array.of(0, 1),
      angles: Float64Array.from([...foldAngles.map((angle) => 0 * angle), ...foldAngles]),
    },
    modelEdges: Int32Array.from(edges.map(({ model }) => number(model[0]!, model[1]!))),
    outlines: walkBoundary(next),
    necks: Float64Array.of(),
    flaps: {
      edges: new Int32Array(),
      bases: new Int32Array(),
      corners: new Float64Array(),
      angles: new Float64Array(),
    },
    labels: [{ text: 'A', x: width / 2, y: height / 2, angle: 0, size: 6 }],
    tapeMarks: new Float64Array(),
    jointLines: new Float64Array(),
    sheet: 0,
    x: 10,
    y: 10,
    angle: 0,
  };
}
