import { cutPairs, edgeLength } from './borders.js';
import type { Piece } from './job.js';

/** One piece on its way into the model. */
export interface Join {
  /** Index of the piece. */
  piece: number;
  /** The pieces before it that it is glued to, ascending; one without any begins a body. */
  partners: number[];
}

/** Per piece, the length of its border with each other piece. */
function sharedBorders(pieces: readonly Piece[]): Map<number, number>[] {
  const shared = pieces.map(() => new Map<number, number>());
  for (const [a, b] of cutPairs(pieces)) {
    if (a.piece === b.piece) continue;
    const length = edgeLength(pieces[a.piece]!, a.edge);
    for (const [one, other] of [
      [a.piece, b.piece],
      [b.piece, a.piece],
    ] as const) {
      shared[one]!.set(other, (shared[one]!.get(other) ?? 0) + length);
    }
  }
  return shared;
}

/** Area of a piece in square millimetres. */
function areaOf({ vertices, faces }: Piece): number {
  let twice = 0;
  for (let at = 0; at < faces.length; at += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => 2 * faces[at + corner]!);
    twice +=
      (vertices[b!]! - vertices[a!]!) * (vertices[c! + 1]! - vertices[a! + 1]!) -
      (vertices[c!]! - vertices[a!]!) * (vertices[b! + 1]! - vertices[a! + 1]!);
  }
  return twice / 2;
}

/**
 * The order in which the pieces become the model: the largest first, then always the one with the
 * longest border to what is already together, so that every piece finds firm ground. Of pieces that
 * have none, as those of another body, the largest is next.
 */
export function joinOrder(pieces: readonly Piece[]): Join[] {
  const shared = sharedBorders(pieces);
  const areas = pieces.map(areaOf);
  const left = new Set(pieces.keys());
  const joins: Join[] = [];
  const joined = new Set<number>();
  const borderOf = (piece: number): number =>
    [...shared[piece]!].reduce((sum, [other, size]) => sum + (joined.has(other) ? size : 0), 0);
  while (left.size > 0) {
    const borders = new Map([...left].map((piece) => [piece, borderOf(piece)]));
    const [piece] = [...left].sort(
      (a, b) => borders.get(b)! - borders.get(a)! || areas[b]! - areas[a]! || a - b,
    );
    const partners = [...shared[piece!]!.keys()].filter((other) => joined.has(other));
    joins.push({ piece: piece!, partners: partners.sort((a, b) => a - b) });
    joined.add(piece!);
    left.delete(piece!);
  }
  return joins;
}
