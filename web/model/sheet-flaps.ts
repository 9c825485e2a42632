import { flapHeights } from './default-options.js';
import type { SheetEdge, SheetEdges, SheetPoint } from './sheet-edges.js';

/** A flap where it lies on its sheet; mm, y up. */
export interface SheetFlap {
  sheet: number;
  /** Foot, top, top and foot, in the direction of its edge. */
  corners: readonly [SheetPoint, SheetPoint, SheetPoint, SheetPoint];
  /** From its base. */
  height: number;
}

/** Hands do not measure more exactly, and neither do people who write a height into a field. */
export const heightStep = 0.5;

/** How far a point is out from the base of a flap. */
function outFrom([foot, top, , end]: SheetFlap['corners'], [x, y]: SheetPoint): number {
  const [alongX, alongY] = [end[0] - foot[0], end[1] - foot[1]];
  const across = (atX: number, atY: number): number =>
    (alongX * (atY - foot[1]) - alongY * (atX - foot[0])) / Math.hypot(alongX, alongY);
  return Math.sign(across(...top)) * across(x, y);
}

/** How far a flap reaches out from its base, mm. @param corners as `Flaps` has them */
export function flapHeight(corners: Float64Array, flap: number): number {
  const points = cornersOf(corners, flap, 0, 0);
  return outFrom(points, points[1]);
}

function cornersOf(
  corners: Float64Array,
  flap: number,
  left: number,
  bottom: number,
): SheetFlap['corners'] {
  const at = (corner: number): SheetPoint => [
    left + corners[8 * flap + 2 * corner]!,
    bottom + corners[8 * flap + 2 * corner + 1]!,
  ];
  return [at(0), at(1), at(2), at(3)];
}

/** The flap at this side of a cut, the first one if the side has several; null without one. */
function flapHere(edges: SheetEdges, edge: SheetEdge): SheetFlap | null {
  const { flaps, sheet, x, y } = edges.result.pieces[edge.piece]!;
  const side = edges.side(edge);
  const flap = flaps.edges.findIndex((own) => side.some((one) => one.edge === own));
  if (flap < 0) return null;
  return {
    sheet,
    corners: cornersOf(flaps.corners, flap, x, y),
    height: flapHeight(flaps.corners, flap),
  };
}

/** The flap of a cut: that of this side if there is one, or else that of the other side; null without any. */
export function flapAt(edges: SheetEdges, edge: SheetEdge): SheetFlap | null {
  const partner = edges.partnerOf(edge);
  return flapHere(edges, edge) ?? (partner && flapHere(edges, partner));
}

/** Where a hand takes a flap to pull it: the middle of its top. */
export function gripOf({ corners: [, one, other] }: SheetFlap): SheetPoint {
  return [(one[0] + other[0]) / 2, (one[1] + other[1]) / 2];
}

/** The height of a flap whose top is pulled to a point, in whole steps and within what flaps may have. */
export function pulledHeight({ corners }: SheetFlap, point: SheetPoint): number {
  const steps = Math.round(outFrom(corners, point) / heightStep);
  return Math.min(flapHeights.most, Math.max(flapHeights.least, steps * heightStep));
}

/** The corners of a flap with another height: its sides keep their directions until they meet. */
export function withHeight({ corners, height }: SheetFlap, wanted: number): SheetFlap['corners'] {
  const [foot, top, otherTop, otherFoot] = corners;
  const share = wanted / height;
  const along = (from: SheetPoint, to: SheetPoint): SheetPoint => [
    from[0] + share * (to[0] - from[0]),
    from[1] + share * (to[1] - from[1]),
  ];
  const [one, other] = [along(foot, top), along(otherFoot, otherTop)];
  const forward =
    (other[0] - one[0]) * (otherFoot[0] - foot[0]) + (other[1] - one[1]) * (otherFoot[1] - foot[1]);
  if (forward >= 0) return [foot, one, other, otherFoot];
  const middle: SheetPoint = [(one[0] + other[0]) / 2, (one[1] + other[1]) / 2];
  return [foot, middle, middle, otherFoot];
}
