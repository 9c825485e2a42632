/** Small models with known nets, for tests that do without the engine. */
import { cutPairs } from '../../web/model/borders.js';
import type { FlapCounts, JobResult, Model, NamedSeam, Piece } from '../../web/model/job.js';
import { layPiece, type Mesh, type Point } from './lay-piece.js';
import { pieceLetter } from './piece-letter.js';

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
