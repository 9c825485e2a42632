/** What pictures of the model are drawn of. */
import type { LineStyle } from '../model/print-options.js';
import type { Point } from './point.js';

export type PictureShape =
  /** Filled, and edged as thinly in the same colour, so that no white shows between neighbours. */
  | { kind: 'area'; colour: string; walks: Point[][] }
  | { kind: 'line'; style: LineStyle; walks: Point[][]; closed: boolean };

/** Of the edges of areas. */
export function edgeStyle(colour: string): LineStyle {
  return { width: 0.05, colour, dash: [] };
}

/** A place on a page: mm from its lower left. */
export interface Frame {
  left: number;
  bottom: number;
  width: number;
  height: number;
}

/** A regular polygon of so many corners around a point, the first one above it; mm. */
export function dotAround([x, y]: Point, radius: number): Point[] {
  // Not by sine and cosine, whose last digits differ between browsers: the corners of an octagon.
  const [near, far] = [0.38268343, 0.92387953];
  const corners = [
    [near, far],
    [-near, far],
    [-far, near],
    [-far, -near],
    [-near, -far],
    [near, -far],
    [far, -near],
    [far, near],
  ];
  return corners.map(([u, v]): Point => [x + radius * u!, y + radius * v!]);
}
