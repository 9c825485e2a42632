/** Seams that are too short to be glued, and what makes them longer: a larger model, or one of fewer faces. */
import { extentsOf } from './bounds.js';
import { doPanelsFit } from './flat-panels.js';
import type { JobResult, Notice, Piece } from './job.js';
import { median } from './median.js';
import { measureSeams } from './seam-measures.js';
import { bandOf, unprinted } from './sheet-room.js';

/** As a fingertip is wide: shorter edges are hard to hold until the glue has dried; mm. */
export const goodSeam = 12;

/** Larger ones fit no table; mm. */
const largestModel = 1000;
/** As many as a pad of card has. */
const mostSheets = 20;
/** With fewer faces fingers and ears are lost. */
const fewestFaces = 200;
/** Edges grow by up to 8 % less than the root of the faces, since the surface loses its bumps, too. */
const reserve = 0.85;
/** Where more edges are flat, faces are shares of large panels: simplifying spoils their shape instead. */
const mostFlat = 0.2;

/** Models that are lower, compared with their longest side, are better told by that. */
const leastUpright = 0.25;

const sides = ['width', 'height', 'depth'] as const;

/** Half of the seams are shorter than this, mm; null if there are none. */
export function medianSeam(result: JobResult): number | null {
  const lengths = measureSeams(result).map(({ length }) => length);
  return lengths.length > 0 ? median(lengths) : null;
}

/** Whether a model can still be printed when it is `factor` times as large. */
function canGrow({ model, pieces, sheets }: JobResult, factor: number, margin: number): boolean {
  const { width, height } = sheets[0]!;
  // Rulers are on two sides, and the other two at least as far from pieces: a larger model has room for sure.
  const border = 2 * bandOf(Math.max(margin, unprinted)).to;
  return (
    factor * Math.max(...extentsOf(model.vertices)) <= largestModel &&
    factor ** 2 * sheets.length <= mostSheets &&
    doPanelsFit(pieces, (width - border) / factor, (height - border) / factor)
  );
}

/** A finished size, mm: one of these, or none. */
export interface Size {
  height?: number;
  width?: number;
  depth?: number;
}

/** The size, in tens of mm, at which edges are `factor` times as long; none if it cannot be printed. */
export function largerSize(result: JobResult, factor: number, margin: number): Size {
  const extents = extentsOf(result.model.vertices);
  const longest = Math.max(...extents);
  const side = extents[1] >= leastUpright * longest ? 1 : extents.indexOf(longest);
  // The last digits of the extents are those of sums.
  const size = Math.ceil((factor * extents[side]!) / 10 - 1e-9) * 10;
  return canGrow(result, size / extents[side]!, margin) ? { [sides[side]!]: size } : {};
}

/** The share of edges within pieces that are not folded at all. */
function flatShare(pieces: readonly Piece[]): number {
  const inner = pieces.flatMap(({ assignments }) => [...assignments.replaceAll('B', '')]);
  return inner.filter((letter) => letter === 'F').length / Math.max(1, inner.length);
}

/** A number that is easily said, not above the given one. */
function roundedDown(number: number): number {
  const steps = [500, 100, 50, 10];
  const step = steps.find((one) => 10 * one <= number) ?? 10;
  return Math.floor(number / step) * step;
}

/** This share of the faces, rounded down; none if they are too few for a shape. */
export function fewerFaces({ model, pieces }: JobResult, share: number): { faces?: number } {
  const faces = roundedDown((share * model.faces.length) / 3);
  const isPossible = faces >= fewestFaces && flatShare(pieces) <= mostFlat;
  return isPossible ? { faces } : {};
}

/** A size in mm, and a number of faces, at which seams are long enough, as far as there are any that are of use. */
export interface LongerSeams extends Size {
  faces?: number;
}

/**
 * What makes seams long enough: a larger model, or fewer faces, among which its surface is shared out.
 *
 * @param margin around each sheet, mm
 * @param wanted how long half of them are to be at least, mm
 */
export function longerSeams(result: JobResult, margin: number, wanted = goodSeam): LongerSeams {
  const factor = wanted / (medianSeam(result) ?? wanted);
  if (factor <= 1) return {};
  return { ...largerSize(result, factor, margin), ...fewerFaces(result, reserve / factor ** 2) };
}

/**
 * One notice if half of the seams are too short to be glued well at this size, with what makes them longer.
 *
 * @param margin around each sheet, mm
 */
export function shortSeams(result: JobResult, margin: number): Notice[] {
  const length = medianSeam(result);
  if (length === null || length >= goodSeam) return [];
  return [{ code: 'short-seams', params: { median_mm: length, ...longerSeams(result, margin) } }];
}
