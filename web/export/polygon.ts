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

/** Smallest upright box around points. */
export function boxOf(
  points: readonly Point[],
): [left: number, bottom: number, right: number, top: number] {
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) {
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  return box;
}
