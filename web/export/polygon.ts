import type { Point, Segment } from './point.js';

/** The sides of a closed walk. */
export function sidesOf(walk: readonly Point[]): Segment[] {
  return walk.map((from, i) => [from, walk[(i + 1) % walk.length]!]);
}

/** Area within a closed walk, positive if it runs counter-clockwise. */
export function areaOf(walk: readonly Point[]): number {
  return sidesOf(walk).reduce((sum, [[x, y], [u, v]]) => sum + x * v - u * y, 0) / 2;
}

/** Whether a point is inside a closed walk, by the even-odd rule; on the walk it may be either. */
export function isInside([x, y]: Point, walk: readonly Point[]): boolean {
  let inside = false;
  for (const [[ax, ay], [bx, by]] of sidesOf(walk)) {
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
  }
  return inside;
}
