import type { Point } from './point.js';
import { areaOf, isInside } from './polygon.js';
import type { PieceDrawing } from './sheet-drawing.js';

const squaredDistance = ([x, y]: Point, [u, v]: Point): number => (x - u) ** 2 + (y - v) ** 2;

/** A piece whose walks are in order, and its last one: the outline. */
interface Candidate {
  piece: PieceDrawing;
  outline: Point[];
  /** Within the outline. */
  area: number;
  start: Point;
}

/** Inner walks lie within larger ones, and what is cut out does not hold still any more. */
function innerFirst(piece: PieceDrawing): Candidate[] {
  const sized = piece.cuts.map((walk) => ({ walk, area: Math.abs(areaOf(walk)) }));
  sized.sort((a, b) => a.area - b.area);
  const [first, last] = [sized[0], sized.at(-1)];
  if (!first || !last) return [];
  const cuts = sized.map(({ walk }) => walk);
  return [
    { piece: { ...piece, cuts }, outline: last.walk, area: last.area, start: first.walk[0]! },
  ];
}

/** Whether a piece lies in a window of another, which is larger: so nothing waits for itself. */
function isWithin(inner: Candidate, outer: Candidate): boolean {
  return inner.area < outer.area && isInside(inner.start, outer.outline);
}

/**
 * Pieces as a machine cuts them: in each, windows before the outline around them; a piece that lies
 * in the window of another before that one; and else always the next one that is nearest to where
 * the last one was left.
 *
 * @param start where the blade is at first
 */
export function inCuttingOrder(pieces: readonly PieceDrawing[], start: Point): PieceDrawing[] {
  const all = pieces.flatMap(innerFirst);
  const within = new Map(
    all.map((outer) => [outer, all.filter((inner) => isWithin(inner, outer))]),
  );
  const left = new Set(all);
  const ordered: PieceDrawing[] = [];
  let at = start;
  while (left.size > 0) {
    const free = [...left].filter((outer) => !within.get(outer)!.some((inner) => left.has(inner)));
    const distance = (candidate: Candidate): number => squaredDistance(at, candidate.start);
    const next = free.reduce((best, other) => (distance(other) < distance(best) ? other : best));
    left.delete(next);
    ordered.push(next.piece);
    at = next.outline[0]!;
  }
  return ordered;
}
