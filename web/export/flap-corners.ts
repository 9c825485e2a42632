import type { Piece } from '../model/job.js';
import type { Point } from './point.js';

export type FlapCorners = [foot: Point, top: Point, otherTop: Point, otherFoot: Point];

/** Of a flap, where it lies on the sheet. */
export function cornersOfFlap({ flaps, x, y }: Piece, flap: number): FlapCorners {
  return [0, 2, 4, 6].map((i): Point => [
    x + flaps.corners[8 * flap + i]!,
    y + flaps.corners[8 * flap + i + 1]!,
  ]) as FlapCorners;
}

export function between([x, y]: Point, [u, v]: Point, share: number): Point {
  return [x + share * (u - x), y + share * (v - y)];
}

/** How far a flap's first top lies from its base. */
export function heightOf([[x, y], [px, py], , [u, v]]: FlapCorners): number {
  return Math.abs((u - x) * (py - y) - (v - y) * (px - x)) / Math.hypot(u - x, v - y);
}
