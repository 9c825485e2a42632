/** Small models with known nets, laid flat here so that exporters can be tested without the engine. */
import { cutPairs } from '../../web/model/borders.js';
import type { FlapCounts, JobResult, Model, NamedSeam, Piece } from '../../web/model/job.js';
import { pieceLetter } from './piece-letter.js';
import { cross, dot, length, minus } from './vectors.js';

type Point = [number, number];

interface Mesh {
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

const noFlaps: FlapCounts = {
  wanted: 0,
  full: 0,
  shrunk: 0,
  missing: { narrow: 0, thin: 0, blocked: 0, short: 0 },
  wanted_mm: 0,
  missing_mm: 0,
  borders: 0,
  strips: 0,
  taped: 0,
};

/** Each pair of cut edges as a seam of its own. */
function seamsOf(pieces: Piece[]): NamedSeam[] {
  return cutPairs(pieces).map(([one, other], i) => {
    const modelEdges = Int32Array.of(pieces[one.piece]!.modelEdges[one.edge]!);
    const at: [number, number] = [one.piece, other.piece];
    const [a, b] = at.map(pieceLetter) as [string, string];
    const number = `${i + 1}`;
    if (a === b) return { modelEdges, pieces: at, texts: [number, number], name: `${a}:${number}` };
    return { modelEdges, pieces: at, texts: [b + number, a + number], name: `${a}-${b}:${number}` };
  });
}

/** A finished job whose pieces lie on A4 sheets, one piece a sheet. */
export function makeResult(mesh: Mesh, pieces: Piece[]): JobResult {
  const model: Model = {
    vertices: Float64Array.from(mesh.vertices.flat()),
    faces: Int32Array.from(mesh.faces.flat()),
    components: 1,
  };
  const labels = new Int32Array(mesh.faces.length);
  pieces.forEach((piece, i) => {
    for (const source of piece.sources) labels[source] = i;
  });
  return {
    file: 'model.obj',
    model,
    deviation: 0,
    repairs: [],
    segmentation: labels.slice(),
    labels,
    parts: pieces.length,
    names: [],
    pieces: pieces.map((piece, i) => ({
      ...piece,
      id: i,
      name: pieceLetter(i),
      part: i,
      sheet: i,
      labels: piece.labels.map((label) => ({ ...label, text: pieceLetter(i) })),
    })),
    nets: [],
    sheets: pieces.map(() => ({ width: 210, height: 297 })),
    strips: [],
    seams: seamsOf(pieces),
    efficiency: 0.25,
    scale: 1,
    flaps: noFlaps,
    ids: { printed: 0, skipped: ['A:3'] },
    search: { generations: 0, moves: 0 },
    notices: [],
    hash: '0123456789abcdef',
  };
}

/** A cube with edges of 40 mm; faces 2i and 2i + 1 are the halves of square i. */
export const cube: Mesh = {
  vertices: [
    [0, 0, 0],
    [40, 0, 0],
    [40, 40, 0],
    [0, 40, 0],
    [0, 0, 40],
    [40, 0, 40],
    [40, 40, 40],
    [0, 40, 40],
  ],
  faces: [
    [0, 3, 2],
    [0, 2, 1], // bottom
    [4, 5, 6],
    [4, 6, 7], // top
    [0, 1, 5],
    [0, 5, 4], // front
    [1, 2, 6],
    [1, 6, 5], // right
    [2, 3, 7],
    [2, 7, 6], // back
    [3, 0, 4],
    [3, 4, 7], // left
  ],
};

/** The usual cross: four sides in a row, top and bottom beside the front. */
export function cubeResult(): JobResult {
  const cross: [number, number][] = [
    [4, 5],
    [4, 7],
    [7, 6],
    [6, 9],
    [9, 8],
    [8, 11],
    [11, 10],
    [4, 1],
    [1, 0],
    [5, 2],
    [2, 3],
  ];
  return makeResult(cube, [layPiece(cube, 4, cross)]);
}

/** The same cube as two pieces: an open box and its lid. */
export function boxAndLidResult(): JobResult {
  const box: [number, number][] = [
    [4, 5],
    [4, 7],
    [7, 6],
    [6, 9],
    [9, 8],
    [8, 11],
    [11, 10],
    [4, 1],
    [1, 0],
  ];
  return makeResult(cube, [layPiece(cube, 4, box), layPiece(cube, 2, [[2, 3]])]);
}

/**
 * A sheet folded by 90 degrees into a valley, with four triangles around a point of the crease.
 * One half of the crease is cut: a slit that opens by nothing when laid flat.
 */
export const bentSheet: Mesh = {
  vertices: [
    [0, 0, 0],
    [0, 30, 0],
    [-30, 0, 0],
    [0, -30, 0],
    [0, 0, 30],
  ],
  faces: [
    [0, 1, 2],
    [0, 2, 3],
    [0, 3, 4],
    [0, 4, 1],
  ],
};

export function slitResult(): JobResult {
  const around: [number, number][] = [
    [0, 1],
    [1, 2],
    [2, 3],
  ];
  return makeResult(bentSheet, [layPiece(bentSheet, 0, around)]);
}

/**
 * Four folds that meet in a point with 360 degrees around it: flat it closes without a gap, and yet
 * one of the folds must be cut to lay it flat fold by fold.
 */
export const beak: Mesh = {
  vertices: [
    [0, 0, 0],
    [15 * Math.sqrt(3), 0, -15],
    [0, 15 * Math.sqrt(3), 15],
    [15 * Math.sqrt(3), 0, 15],
    [0, -15 * Math.sqrt(3), 15],
  ],
  faces: [
    [0, 1, 2],
    [0, 2, 3],
    [0, 3, 4],
    [0, 4, 1],
  ],
};

export function beakResult(): JobResult {
  const around: [number, number][] = [
    [0, 1],
    [1, 2],
    [2, 3],
  ];
  return makeResult(beak, [layPiece(beak, 0, around)]);
}

/** A regular tetrahedron with edges of 40 mm and all its folds mountains. */
export const tetrahedron: Mesh = {
  vertices: [
    [0, 0, 0],
    [40, 0, 0],
    [20, 20 * Math.sqrt(3), 0],
    [20, (20 / 3) * Math.sqrt(3), 40 * Math.sqrt(2 / 3)],
  ],
  faces: [
    [0, 2, 1],
    [0, 1, 3],
    [1, 2, 3],
    [2, 0, 3],
  ],
};

export function tetrahedronResult(): JobResult {
  const star: [number, number][] = [
    [0, 1],
    [0, 2],
    [0, 3],
  ];
  return makeResult(tetrahedron, [layPiece(tetrahedron, 0, star)]);
}

/** The slit sheet with a flap on the first edge of its outline: half as wide as the edge, at its end. */
export function flapResult(): JobResult {
  const result = slitResult();
  const [piece] = result.pieces;
  const outline = piece!.outlines[0]!;
  const edge = piece!.modelEdges.findIndex(
    (_, e) => piece!.assignments[e] === 'B' && piece!.edges[2 * e] === outline[0],
  );
  const at = (vertex: number): Point => [
    piece!.vertices[2 * vertex]!,
    piece!.vertices[2 * vertex + 1]!,
  ];
  const [from, to] = [at(piece!.edges[2 * edge]!), at(piece!.edges[2 * edge + 1]!)];
  const on = (along: number, out: number): Point => [
    from[0] + along * (to[0] - from[0]) + out * (to[1] - from[1]),
    from[1] + along * (to[1] - from[1]) - out * (to[0] - from[0]),
  ];
  piece!.flaps = {
    edges: Int32Array.of(edge),
    bases: piece!.edges.slice(2 * edge, 2 * edge + 2),
    corners: Float64Array.from([on(0.5, 0), on(0.6, 0.1), on(0.9, 0.1), on(1, 0)].flat()),
    angles: Float64Array.of(90),
  };
  return result;
}
