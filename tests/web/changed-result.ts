/** Results of fixtures, changed. */
import type { JobResult, Piece } from '../../web/model/job.js';

function times(values: Float64Array, factor: number): Float64Array {
  return values.map((value) => factor * value);
}

function scaledPiece(piece: Piece, factor: number): Piece {
  return {
    ...piece,
    width: factor * piece.width,
    height: factor * piece.height,
    vertices: times(piece.vertices, factor),
  };
}

/** The same model and pieces without flaps, larger or smaller. */
export function scaled(result: JobResult, factor: number): JobResult {
  return {
    ...result,
    model: { ...result.model, vertices: times(result.model.vertices, factor) },
    pieces: result.pieces.map((piece) => scaledPiece(piece, factor)),
  };
}

/** Puts an upright flap of this height to a seam, at the first of its sides. */
export function addFlap({ pieces, seams }: JobResult, seam: number, height: number): void {
  const { modelEdges, pieces: sides } = seams[seam]!;
  const piece = pieces[sides[0]]!;
  const edge = piece.modelEdges.indexOf(modelEdges[0]!);
  const base = piece.edges.slice(2 * edge, 2 * edge + 2);
  const [ax, ay, bx, by] = [...base].flatMap((v) => [...piece.vertices.slice(2 * v, 2 * v + 2)]);
  const length = Math.hypot(bx! - ax!, by! - ay!);
  const [x, y] = [((by! - ay!) * height) / length, ((ax! - bx!) * height) / length];
  const corners = [ax!, ay!, ax! + x, ay! + y, bx! + x, by! + y, bx!, by!];
  const { flaps } = piece;
  piece.flaps = {
    edges: Int32Array.of(...flaps.edges, edge),
    bases: Int32Array.of(...flaps.bases, ...base),
    corners: Float64Array.of(...flaps.corners, ...corners),
    angles: Float64Array.of(...flaps.angles, -90),
  };
}
