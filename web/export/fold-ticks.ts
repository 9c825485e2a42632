import type { Point, Segment } from './point.js';
import type { PieceDrawing } from './sheet-drawing.js';

/** Long enough to lay a ruler along, and to show a dash and a gap; mm. */
const tickLength = 3;

/** Two marks, from each end inwards: 3 mm, or a third of a shorter fold. */
function ticksOf([from, to]: Segment): Segment[] {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (length === 0) return [];
  const share = Math.min(1 / 3, tickLength / length);
  const inwards = (start: Point, end: Point): Segment => [
    start,
    [start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])],
  ];
  return [inwards(from, to), inwards(to, from)];
}

/** A piece with marks at both ends of its folds instead of lines across its faces. */
export function withFoldTicks(piece: PieceDrawing): PieceDrawing {
  return {
    ...piece,
    mountains: piece.mountains.flatMap(ticksOf),
    valleys: piece.valleys.flatMap(ticksOf),
  };
}
