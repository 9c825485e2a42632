import { cutPairs, edgeLength } from './borders.js';
import type { JobResult, NamedSeam, Piece } from './job.js';
import { flapHeight } from './sheet-flaps.js';

/** A seam with what it takes on paper. */
export interface MeasuredSeam {
  seam: NamedSeam;
  /** Of the edges on one side, mm. */
  length: number;
  /** Height of its flap, of the higher one if it has two, mm; 0 without one. */
  flap: number;
  /** Whether an edge stands on another surface there, instead of two sides of a cut that meet. */
  isJoint: boolean;
}

/** Shorter seams hold by their neighbours, so the engine wants no flaps there; mm. */
export const wantedLength = 4;

/** Lengths of edges of the model on paper. */
function edgeLengths(pieces: readonly Piece[]): Map<number, number> {
  const lengths = new Map<number, number>();
  for (const piece of pieces) {
    piece.modelEdges.forEach((modelEdge, edge) => lengths.set(modelEdge, edgeLength(piece, edge)));
  }
  return lengths;
}

/** Heights of flaps by the edge of the model that each begins with; of two the higher. */
function flapHeights(pieces: readonly Piece[]): Map<number, number> {
  const heights = new Map<number, number>();
  for (const { flaps, modelEdges } of pieces) {
    flaps.edges.forEach((edge, flap) => {
      const height = flapHeight(flaps.corners, flap);
      heights.set(modelEdges[edge]!, Math.max(height, heights.get(modelEdges[edge]!) ?? 0));
    });
  }
  return heights;
}

/** All seams of a result, in its order. */
export function measureSeams({ pieces, seams }: JobResult): MeasuredSeam[] {
  const [lengths, heights] = [edgeLengths(pieces), flapHeights(pieces)];
  const closed = new Set(
    cutPairs(pieces).map(([{ piece, edge }]) => pieces[piece]!.modelEdges[edge]!),
  );
  return seams.map((seam) => {
    const edges = [...seam.modelEdges];
    return {
      seam,
      length: edges.reduce((sum, edge) => sum + (lengths.get(edge) ?? 0), 0),
      flap: Math.max(0, ...edges.map((edge) => heights.get(edge) ?? 0)),
      isJoint: !closed.has(edges[0]!),
    };
  });
}

/** The seams that the engine wants a flap for, but for those where a person wanted none. */
export function wantedSeams(result: JobResult): MeasuredSeam[] {
  return measureSeams(result).filter(({ isJoint, length }) => !isJoint && length > wantedLength);
}

/** The seams that want a flap and have neither one nor a loose strip in its place. */
export function bareSeams(result: JobResult): MeasuredSeam[] {
  const joined = new Set(result.strips.map(({ id }) => id));
  return wantedSeams(result).filter(({ flap, seam }) => flap === 0 && !joined.has(seam.name));
}

/**
 * Heights of the flaps that are lower than wished for, ascending, mm; as many as `flaps.shrunk` counts.
 * All flaps are taken to be wished for as high, which only differs where a person chose for single edges.
 */
export function shrunkHeights(result: JobResult): number[] {
  const heights = wantedSeams(result).flatMap(({ flap }) => (flap > 0 ? [flap] : []));
  return heights.sort((a, b) => a - b).slice(0, result.flaps.shrunk);
}

/** What there is to be glued, mm: within pieces, and from piece to piece. */
export interface Glue {
  within: { seams: number; mm: number };
  between: { seams: number; mm: number };
}

/** Seams by whether they close a piece or join two. */
export function glueOf(seams: readonly MeasuredSeam[]): Glue {
  const glue: Glue = { within: { seams: 0, mm: 0 }, between: { seams: 0, mm: 0 } };
  for (const { seam, length } of seams) {
    const kind = glue[seam.pieces[0] === seam.pieces[1] ? 'within' : 'between'];
    kind.seams += 1;
    kind.mm += length;
  }
  return glue;
}
