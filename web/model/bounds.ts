import { length, minus, plus, times, vectorAt, type Vector } from './vector.js';

/** An upright box in space. */
export interface Box3 {
  low: Vector;
  high: Vector;
}

export interface Ball {
  centre: Vector;
  radius: number;
}

/** The box around all points of one or more arrays of 3 numbers per point; at least one point. */
export function boxOf(...arrays: ArrayLike<number>[]): Box3 {
  const low = [Infinity, Infinity, Infinity] as [number, number, number];
  const high = [-Infinity, -Infinity, -Infinity] as [number, number, number];
  for (const points of arrays) {
    for (let i = 0; i < points.length; ++i) {
      low[i % 3] = Math.min(low[i % 3]!, points[i]!);
      high[i % 3] = Math.max(high[i % 3]!, points[i]!);
    }
  }
  return { low, high };
}

/** How far points reach along x, y and z, of an array of 3 numbers per point; at least one point. */
export function extentsOf(points: ArrayLike<number>): Vector {
  const { low, high } = boxOf(points);
  return minus(high, low);
}

/** A ball around all points, from the middle of their box. */
export function ballOf(points: ArrayLike<number>): Ball {
  const { low, high } = boxOf(points);
  const centre = times(plus(low, high), 0.5);
  let radius = 0;
  for (let i = 0; i < points.length / 3; ++i) {
    radius = Math.max(radius, length(minus(vectorAt(points, i), centre)));
  }
  return { centre, radius };
}
