/** What flaps look like on paper that is not thin. */
import type { Piece } from '../model/job.js';
import { between, cornersOfFlap, heightOf, type FlapCorners } from './flap-corners.js';
import type { Point, Segment } from './point.js';

/** How a flap is drawn, where it lies on the sheet. */
export interface FlapShape {
  corners: FlapCorners;
  /** What the cut goes along from foot to foot; nicks are walked there and back. */
  cut: Point[];
  /** Where it is folded. */
  fold: Segment;
}

/** How far a fold steps at most, where faces are folded onto each other, over the thickness of the paper. */
const mostStep = 2;

/** Shares of its length that a fold may lose at each end, and of its height a flap. */
const mostLoss = { end: 0.25, height: 0.5 };

/** An end of a flap's base, and what the face does behind it. */
interface BaseEnd {
  /** From the end of the edges that the flap is attached to, to its foot; mm. */
  inset: number;
  /** By how much the face gets shorter there per step inwards: cotangent of its angle, at least 0. */
  narrowing: number;
}

/** The third vertex of the face that has an edge. */
function acrossFace({ faces }: Piece, from: number, to: number): number {
  for (let i = 0; i < faces.length; ++i) {
    const [next, last] = [i % 3 === 2 ? i - 2 : i + 1, i % 3 === 0 ? i + 2 : i - 1];
    if (faces[i] === from && faces[next] === to) return faces[last]!;
  }
  throw new Error('The outline runs along no face');
}

/** The vertex after one, or before it, on the outline. */
function neighbourOf({ outlines }: Piece, vertex: number, step: 1 | -1): number {
  const outline = outlines.find((walk) => walk.includes(vertex))!;
  return outline.at((outline.indexOf(vertex) + step) % outline.length)!;
}

function endOf(piece: Piece, flap: number, end: 0 | 1): BaseEnd {
  const at = (vertex: number): Point => [
    piece.vertices[2 * vertex]!,
    piece.vertices[2 * vertex + 1]!,
  ];
  const vertex = piece.flaps.bases[2 * flap + end]!;
  const along = neighbourOf(piece, vertex, end === 0 ? 1 : -1);
  const across = end === 0 ? acrossFace(piece, vertex, along) : acrossFace(piece, along, vertex);
  const [x, y] = at(vertex);
  const [[u, v], [p, q]] = [at(along), at(across)];
  const cotangent =
    ((u - x) * (p - x) + (v - y) * (q - y)) / Math.abs((u - x) * (q - y) - (v - y) * (p - x));
  const foot = 8 * flap + 6 * end;
  const { corners } = piece.flaps;
  return {
    inset: Math.hypot(corners[foot]! - x, corners[foot + 1]! - y),
    narrowing: Math.max(0, cotangent),
  };
}

/** The fold steps onto the flap. */
function stepOut(corners: FlapCorners, wished: number): FlapShape {
  const [foot, top, otherTop, otherFoot] = corners;
  const share = Math.min(wished / heightOf(corners), mostLoss.height);
  const fold: Segment = [between(foot, top, share), between(otherFoot, otherTop, share)];
  return { corners, cut: corners, fold };
}

/** The fold steps into the face; nicks free its ends, and the flap's top comes after it. */
function stepIn(corners: FlapCorners, wished: number, ends: readonly BaseEnd[]): FlapShape {
  const [foot, top, otherTop, otherFoot] = corners;
  const [x, y] = [otherFoot[0] - foot[0], otherFoot[1] - foot[1]];
  const length = Math.hypot(x, y);
  const height = heightOf(corners);
  const narrowest = Math.max(...ends.map(({ narrowing }) => narrowing));
  const step = Math.min(
    wished,
    mostLoss.height * height,
    narrowest > 0 ? (mostLoss.end * length) / narrowest : Infinity,
  );
  // Pieces run counter-clockwise: the face is on the left.
  const inwards = (along: number): Point => [
    foot[0] + (along * x - step * y) / length,
    foot[1] + (along * y + step * x) / length,
  ];
  const [start, end] = ends.map(({ inset, narrowing }) => Math.max(0, step * narrowing - inset));
  const fold: Segment = [inwards(start!), inwards(length - end!)];
  const stays = 1 - step / height;
  const tops = [between(foot, top, stays), between(otherFoot, otherTop, stays)] as const;
  return {
    corners: [foot, ...tops, otherFoot],
    cut: [foot, fold[0], foot, ...tops, otherFoot, fold[1], otherFoot],
    fold,
  };
}

/**
 * A flap lies behind the paper of its neighbour. Where that face is bent down (a mountain), this
 * one has to end before the neighbour's back; where it rises (a valley), it goes on until there. So
 * the fold steps by the thickness times the tangent of half the fold angle, at most by twice the
 * thickness, half the flap, or what takes a quarter of the fold at one end. A flap whose fold steps
 * into the face gets lower by as much, so that it reaches no further behind the neighbour.
 *
 * @param thickness of the paper, mm; on paper without one, folds go from foot to foot
 */
export function flapShape(piece: Piece, flap: number, thickness: number): FlapShape {
  const corners = cornersOfFlap(piece, flap);
  const angle = piece.flaps.angles[flap]!;
  const wished = thickness * Math.min(mostStep, Math.tan((Math.abs(angle) * Math.PI) / 360));
  if (wished === 0) return { corners, cut: corners, fold: [corners[0], corners[3]] };
  if (angle > 0) return stepOut(corners, wished);
  return stepIn(corners, wished, [endOf(piece, flap, 0), endOf(piece, flap, 1)]);
}
