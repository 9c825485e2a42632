import type { DocumentEdit } from './document-edits.js';
import type { JobResult, Piece } from './job.js';
import type { PinnedPiece } from './job-options.js';
import { partNeighbours } from './part-neighbours.js';
import type { PiecePlace } from './piece-shape.js';

/** Whether a pin is for this piece. */
export function isPinOf({ part, face }: PinnedPiece, piece: Piece): boolean {
  return part === piece.part && face === piece.sources[0];
}

/** Lays a piece, by its index, at a place where it then stays. */
export function placing(piece: number, { sheet, x, y, turn }: PiecePlace): DocumentEdit {
  return { kind: 'place', piece: piece + 1, sheet: sheet + 1, x_mm: x, y_mm: y, turn_deg: turn };
}

/** What happens to a piece that is laid at a place. */
export type Laying = 'moved' | 'turned' | 'kept';

/** What is the same place or turn, in mm and degrees: an edit may have been written with few digits. */
const same = 1e-3;

/** What laying a piece at a place does, seen from where it lies. */
export function layingOf({ sheet, x, y, angle }: Piece, place: PiecePlace): Laying {
  if (Math.abs(place.turn - angle) > same) return 'turned';
  const isThere = place.sheet === sheet && Math.hypot(place.x - x, place.y - y) <= same;
  return isThere ? 'kept' : 'moved';
}

/** A part that another one can be joined with, from 0, and the names of its pieces. */
export interface PartOffer {
  part: number;
  pieces: readonly string[];
}

/** The parts that touch a part, from 0. */
export function joinOffers(result: JobResult, part: number): PartOffer[] {
  const neighbours = [...(partNeighbours(result)[part] ?? [])].sort((a, b) => a - b);
  return neighbours.map((other) => {
    const own = result.pieces.filter((piece) => piece.part === other);
    return { part: other, pieces: own.map(({ name }) => name) };
  });
}
