import { describe, expect, it } from 'vitest';
import { clipped, halves, leftOf, remainder, sidesOf } from '../../web/export/convex.js';
import { areaOf } from '../../web/export/polygon.js';
import type { Point } from '../../web/export/point.js';

const square: Point[] = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];
/** Meets the square in a triangle of area 2. */
const corner: Point[] = [
  [2, 0],
  [6, 0],
  [6, 4],
];
const sum = (polygons: Point[][]) => polygons.reduce((all, one) => all + areaOf(one), 0);

describe('convex polygons', () => {
  it('are halved without losing area', () => {
    const { within, beyond } = halves(square, leftOf([1, -1], [2, 7]));
    expect(areaOf(within) + areaOf(beyond)).toBeCloseTo(16, 12);
    expect(areaOf(within)).toBeCloseTo(5.5, 12);
  });

  it('are whole on one side of a line that misses or touches them', () => {
    expect(halves(square, leftOf([5, 0], [5, 1])).within).toEqual(square);
    expect(halves(square, leftOf([4, 0], [4, 1])).within).toEqual(square);
    expect(halves(square, leftOf([5, 1], [5, 0])).within).toEqual([]);
  });

  it('share what lies in both', () => {
    expect(areaOf(clipped(square, sidesOf(corner)))).toBeCloseTo(2, 12);
    const far = corner.map(([x, y]): Point => [x + 9, y]);
    expect(clipped(square, sidesOf(far))).toEqual([]);
  });

  it('keep the rest of their area when another one is cut away', () => {
    expect(sum(remainder(square, sidesOf(corner), 0))).toBeCloseTo(14, 12);
    expect(remainder(square, sidesOf(square), 1e-9)).toEqual([]);
  });
});
