import type { PiecePlace } from './piece-shape.js';
import type { Area } from './sheet-room.js';

/** The nearest of some numbers, if it is within reach. */
function near(value: number, numbers: readonly number[], reach: number): number | null {
  const best = numbers.reduce((a, b) => (Math.abs(b - value) < Math.abs(a - value) ? b : a));
  return Math.abs(best - value) <= reach ? best : null;
}

/**
 * A place on whole millimetres, or at the edges of what can be printed on where these are near.
 *
 * @param size width and height of the piece there, mm
 * @param reach of the edges, mm
 */
export function snappedPlace(
  place: PiecePlace,
  [width, height]: readonly [number, number],
  { left, bottom, right, top }: Area,
  reach: number,
): PiecePlace {
  const x = near(place.x, [left, right - width], reach) ?? Math.round(place.x);
  const y = near(place.y, [bottom, top - height], reach) ?? Math.round(place.y);
  return { ...place, x, y };
}
