import type { Point, Segment } from './point.js';

/** An upright or turned box. */
export interface Box {
  middle: Point;
  along: Point;
  halfWidth: number;
  halfHeight: number;
}

/** Whether a line has a point in a box (Liang and Barsky's clipping). */
export function meets({ middle, along, halfWidth, halfHeight }: Box, [from, to]: Segment): boolean {
  let [enter, leave] = [0, 1];
  for (const [[ux, uy], half] of [
    [along, halfWidth],
    [[-along[1], along[0]], halfHeight],
  ] as const) {
    const start = (from[0] - middle[0]) * ux + (from[1] - middle[1]) * uy;
    const step = (to[0] - from[0]) * ux + (to[1] - from[1]) * uy;
    if (Math.abs(step) < 1e-12) {
      if (Math.abs(start) >= half) return false;
      continue;
    }
    const [a, b] = [(-half - start) / step, (half - start) / step];
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
  }
  return enter < leave;
}
