import type { Piece } from '../../model/job.js';
import type { FlapBleed } from '../../model/print-options.js';
import { between, cornersOfFlap, heightOf, type FlapCorners } from '../flap-corners.js';
import type { Point } from '../point.js';

/** How far colours go beyond cuts, so that no white shows where scissors miss the line; mm. */
export const bleedReach = 0.5;

const shares: Readonly<Record<FlapBleed, number>> = { none: 0, half: 0.5, whole: 1 };

/** What colours cover of each flap of a piece, where it lies on the sheet; nothing if they shall cover none. */
export function bledFlaps(piece: Piece, flapBleed: FlapBleed): Point[][] {
  const share = shares[flapBleed];
  if (share === 0) return [];
  return Array.from(piece.flaps.edges, (_, flap) => {
    const [foot, top, otherTop, otherFoot] = cornersOfFlap(piece, flap);
    return [foot, between(foot, top, share), between(otherFoot, otherTop, share), otherFoot];
  });
}

/** What colours leave of a flap, which may be filled: one walk, or none if that is nothing. */
export function bareFlap(corners: FlapCorners, flapBleed: FlapBleed): Point[][] {
  const [foot, top, otherTop, otherFoot] = corners;
  // Colours go so far beyond what they shall cover.
  const share = shares[flapBleed] + bleedReach / heightOf(corners);
  if (!(share < 1)) return [];
  return [[between(foot, top, share), top, otherTop, between(otherFoot, otherTop, share)]];
}
