import type { Point } from './point.js';
import { areaOf, isInside } from './polygon.js';
import type { PieceDrawing } from './sheet-drawing.js';

const squaredDistance = ([x, y]: Point, [u, v]: Point): number => (x - u) ** 2 + (y - v) ** 2;

/** Inner walks lie within larger ones, and what is cut out does not hold still any more. */
function innerFirst(piece: PieceDrawing): PieceDrawing {
  const sized = piece.cuts.map((walk) => ({ walk, area: Math.abs(areaOf(walk)) }));
  return { ...piece, cuts: sized.sort((a, b) => a.area - b.area).map(({ walk }) => walk) };
}

/**
 * Pieces as a machine cuts them: in each, windows before the outline around them; a piece that lies
 * in the window of another before that one; and else always the next one that is nearest to where
 * the last one was left.
 *
 * @param start where the blade is at first
 */
export function inCuttingOrder(pieces: readonly PieceDrawing[], start: Point): PieceDrawing[] {
  const left = pieces.filter(({ cuts }) => cuts.length > 0).map(innerFirst);
  const ordered: PieceDrawing[] = [];
  let at = start;
  while (left.length > 0) {
    const free = left.filter((piece) => {
      const outline = piece.cuts.at(-1)!;
      return !left.some((other) => other !== piece && isInside(other.cuts[0]![0]!, outline));
    });
    const distance = ({ cuts }: PieceDrawing): number => squaredDistance(at, cuts[0]![0]!);
    const next = free.reduce((best, piece) => (distance(piece) < distance(best) ? piece : best));
    left.splice(left.indexOf(next), 1);
    ordered.push(next);
    at = next.cuts.at(-1)![0]!;
  }
  return ordered;
}
