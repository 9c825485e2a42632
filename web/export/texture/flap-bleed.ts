import type { Piece } from '../../model/job.js';
import type { FlapBleed } from '../../model/print-options.js';
import type { Point } from '../point.js';

/** How far colours go beyond cuts, so that no white shows where scissors miss the line; mm. */
export const bleedReach = 0.5;

const shares: Readonly<Record<FlapBleed, number>> = { none: 0, half: 0.5, whole: 1 };

function between([x, y]: Point, [u, v]: Point, share: number): Point {
  return [x + share * (u - x), y + share * (v - y)];
}

type FlapCorners = [foot: Point, top: Point, otherTop: Point, otherFoot: Point];

/** What colours cover of each flap of a piece, where it lies on the sheet; nothing if they shall cover none. */
export function bledFlaps({ flaps, x, y }: Piece, flapBleed: FlapBleed): Point[][] {
  const share = shares[flapBleed];
  if (share === 0) return [];
  return Array.from(flaps.edges, (_, flap) => {
    const [foot, top, otherTop, otherFoot] = [0, 2, 4, 6].map((i): Point => [
      x + flaps.corners[8 * flap + i]!,
      y + flaps.corners[8 * flap + i + 1]!,
    ]) as FlapCorners;
    return [foot, between(foot, top, share), between(otherFoot, otherTop, share), otherFoot];
  });
}

/** What colours leave of a flap, which may be filled: one walk, or none if that is nothing. */
export function bareFlap(walk: readonly Point[], flapBleed: FlapBleed): Point[][] {
  const [foot, top, otherTop, otherFoot] = walk as FlapCorners;
  const height = heightOf(foot, otherFoot, top);
  // Colours go so far beyond what they shall cover.
  const share = shares[flapBleed] + bleedReach / height;
  if (!(share < 1)) return [];
  return [[between(foot, top, share), top, otherTop, between(otherFoot, otherTop, share)]];
}

/** How far a point lies from a line through two others. */
function heightOf([x, y]: Point, [u, v]: Point, [px, py]: Point): number {
  return Math.abs((u - x) * (py - y) - (v - y) * (px - x)) / Math.hypot(u - x, v - y);
}
