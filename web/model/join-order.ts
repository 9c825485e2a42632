import { cutPairs, edgeLength } from './borders.js';
import type { Piece } from './job.js';

/** One piece on its way into the model. */
export interface Join {
  /** Index of the piece. */
  piece: number;
  /** Edges that it is glued along to the pieces before it; none begins another body. */
  edges: number;
  /** The pieces before it that it is glued to, ascending. */
  partners: number[];
}

/** Border that a piece shares with others: per other piece the number and the length of the edges. */
type Shared = Map<number, { edges: number; length: number }>;

function sharedBorders(pieces: readonly Piece[]): Shared[] {
  const shared = pieces.map((): Shared => new Map());
  const add = (a: number, b: number, length: number): void => {
    const before = shared[a]!.get(b) ?? { edges: 0, length: 0 };
    shared[a]!.set(b, { edges: before.edges + 1, length: before.length + length });
  };
  for (const [a, b] of cutPairs(pieces)) {
    if (a.piece === b.piece) continue;
    const length = edgeLength(pieces[a.piece]!, a.edge);
    add(a.piece, b.piece, length);
    add(b.piece, a.piece, length);
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
    [...shared[piece]!].reduce(
      (sum, [other, { length }]) => sum + (joined.has(other) ? length : 0),
      0,
    );
  while (left.size > 0) {
    const borders = new Map([...left].map((piece) => [piece, borderOf(piece)]));
    const [piece] = [...left].sort(
      (a, b) => borders.get(b)! - borders.get(a)! || areas[b]! - areas[a]! || a - b,
    );
    const partners = [...shared[piece!]!.keys()].filter((other) => joined.has(other));
    const edges = partners.reduce((sum, other) => sum + shared[piece!]!.get(other)!.edges, 0);
    joins.push({ piece: piece!, edges, partners: partners.sort((a, b) => a - b) });
    joined.add(piece!);
    left.delete(piece!);
  }
  return joins;
}
