import { describe, expect, it } from 'vitest';
import { flapShape } from '../../web/export/flap-shape.js';
import type { Piece } from '../../web/model/job.js';
import { cubeResult } from './fixtures.js';

/** A triangle 40 wide with its apex at (x, 30), on a sheet at (100, 50), with a flap of 5 mm below its base. */
function triangle(apex: number, angle: number, feet: [number, number] = [0, 40]): Piece {
  const [piece] = cubeResult().pieces;
  const [from, to] = feet;
  return {
    ...piece!,
    x: 100,
    y: 50,
    vertices: Float64Array.of(0, 0, 40, 0, apex, 30),
    faces: Int32Array.of(0, 1, 2),
    sources: Int32Array.of(0),
    edges: Int32Array.of(0, 1, 1, 2, 2, 0),
    assignments: 'BBB',
    foldAngles: Float64Array.of(NaN, NaN, NaN),
    outlines: [Int32Array.of(0, 1, 2)],
    flaps: {
      edges: Int32Array.of(0),
      bases: Int32Array.of(0, 1),
      corners: Float64Array.of(from, 0, from + 5, -5, to - 5, -5, to, 0),
      angles: Float64Array.of(angle),
    },
  };
}

/** Points from the piece's corner, without the noise of the last digits. */
function local(points: readonly (readonly [number, number])[]): [number, number][] {
  return points.map(([x, y]) => [
    Math.round(1e9 * (x - 100)) / 1e9 + 0,
    Math.round(1e9 * (y - 50)) / 1e9 + 0,
  ]);
}

describe('the fold of a flap', () => {
  it('goes from foot to foot on paper without thickness', () => {
    const { corners, cut, fold } = flapShape(triangle(20, -90), 0, 0);
    expect(cut).toBe(corners);
    expect(local(fold)).toEqual([
      [0, 0],
      [40, 0],
    ]);
  });

  it('steps into the face at a mountain, and the flap gets lower by as much', () => {
    const { corners, cut, fold } = flapShape(triangle(20, -90), 0, 1);
    // The sides rise by 3 for 2.
    expect(local(fold)).toEqual([
      [0.666666667, 1],
      [39.333333333, 1],
    ]);
    const lower: [number, number][] = [
      [0, 0],
      [4, -4],
      [36, -4],
      [40, 0],
    ];
    expect(local(corners)).toEqual(lower);
    expect(local(cut)).toEqual([[0, 0], [0.666666667, 1], ...lower, [39.333333333, 1], [40, 0]]);
  });

  it('goes straight inwards where the face widens, or the flap begins further in', () => {
    expect(local(flapShape(triangle(-10, -90), 0, 1).fold)[0]).toEqual([0, 1]);
    expect(local(flapShape(triangle(20, -90, [3, 40]), 0, 1).fold)[0]).toEqual([3, 1]);
  });

  it('steps onto the flap at a valley', () => {
    const { corners, cut, fold } = flapShape(triangle(20, 90), 0, 1);
    expect(cut).toBe(corners);
    expect(local(fold)).toEqual([
      [1, -1],
      [39, -1],
    ]);
  });

  it.each([
    ['less where folds are flatter', -60, 1, Math.tan(Math.PI / 6)],
    ['by twice the thickness where faces lie on each other', -180, 0.8, 1.6],
    ['by half the flap', -90, 3, 2.5],
  ])('steps %s', (_, angle, thickness, step) => {
    const { fold } = flapShape(triangle(20, angle), 0, thickness);
    expect(fold[0][1] - 50).toBeCloseTo(step, 9);
  });

  it('keeps half of its length on a thin face', () => {
    const piece = triangle(20, -90);
    piece.vertices[5] = 2;
    const [from, to] = local(flapShape(piece, 0, 2.5).fold);
    expect(from![0]).toBeCloseTo(10, 9);
    expect(to![0]).toBeCloseTo(30, 9);
  });
});
