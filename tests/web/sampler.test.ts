import { describe, expect, it } from 'vitest';
import { footprintOf } from '../../web/export/texture/footprint.js';
import { halved, type Raster } from '../../web/export/texture/raster.js';
import { Sampler, wrapped } from '../../web/export/texture/sampler.js';
import type { Wrap } from '../../web/model/looks.js';

function rasterOf(
  width: number,
  height: number,
  valueAt: (x: number, y: number) => number,
): Raster {
  const values = Array.from({ length: width * height }, (_, i) =>
    valueAt(i % width, Math.floor(i / width)),
  );
  return { width, height, rgb: Uint8Array.from(values.flatMap((value) => [value, value, 0])) };
}

/** Red at a place, when a dot of paper shows so many pixels across and down. */
function valueAt(sampler: Sampler, x: number, y: number, across = 0, down = across): number {
  const colour = Float64Array.of(255, 255, 255);
  sampler.tint(x, y, footprintOf([across, 0, 0, down]), colour);
  expect(colour[2]).toBe(0);
  return colour[0]!;
}

const clamp: [Wrap, Wrap] = ['clamp', 'clamp'];

describe('wrapped', () => {
  it.each([
    ['repeat', [2, 0, 1, 2, 0, 1, 2, 0, 1]],
    ['mirror', [2, 2, 1, 0, 0, 1, 2, 2, 1]],
    ['clamp', [0, 0, 0, 0, 0, 1, 2, 2, 2]],
  ] as const)('goes on by %s', (wrap, expected) => {
    expect([-4, -3, -2, -1, 0, 1, 2, 3, 4].map((index) => wrapped(index, 3, wrap))).toEqual(
      expected,
    );
  });

  it('stays within however far away', () => {
    for (const wrap of ['repeat', 'mirror', 'clamp'] as const) {
      for (const index of [-1e15, 1e15, 123_456_789]) {
        const at = wrapped(index, 7, wrap);
        expect(at >= 0 && at < 7 && Number.isInteger(at)).toBe(true);
      }
    }
  });
});

describe('Sampler', () => {
  it('shows pixels in their middles, and between two what lies between', () => {
    const sampler = new Sampler(
      rasterOf(2, 1, (x) => 100 * x + 50),
      clamp,
    );
    expect(valueAt(sampler, 0.5, 0.5)).toBeCloseTo(50);
    expect(valueAt(sampler, 1.5, 0.5)).toBeCloseTo(150);
    expect(valueAt(sampler, 1, 0.5)).toBeCloseTo(100);
    expect(valueAt(sampler, -9, 0.5)).toBeCloseTo(50);
  });

  it('goes on beyond the edges as its wraps say', () => {
    const picture = rasterOf(3, 3, (x, y) => 10 * x + 100 * Number(y === 0));
    const sampler = new Sampler(picture, ['repeat', 'mirror']);
    expect(valueAt(sampler, 4.5, 1.5)).toBeCloseTo(10);
    expect(valueAt(sampler, 0.5, -0.5)).toBeCloseTo(100);
    expect(valueAt(sampler, 0.5, -1.5)).toBeCloseTo(0);
    // Between the last column and the first one.
    expect(valueAt(sampler, 3, 1.5)).toBeCloseTo(10);
  });

  it.each([2, 3, 5, 8, 100])('shows the mean where a dot covers %i pixels', (size) => {
    const board = rasterOf(256, 256, (x, y) => 200 * ((x + y) & 1));
    const sampler = new Sampler(board, ['repeat', 'repeat']);
    for (const at of [10, 33.3, 100.7]) {
      expect(Math.abs(valueAt(sampler, at, at, size) - 100)).toBeLessThan(12);
    }
  });

  it('keeps lines apart along which a slanted face is not squeezed', () => {
    const stripes = new Sampler(
      rasterOf(64, 64, (x) => 200 * ((x >> 2) & 1)),
      clamp,
    );
    // Sixteen pixels high and one wide.
    expect(valueAt(stripes, 34, 32, 1, 16)).toBeLessThan(20);
    expect(valueAt(stripes, 38, 32, 1, 16)).toBeGreaterThan(180);
  });

  it('multiplies', () => {
    const sampler = new Sampler(
      rasterOf(1, 1, () => 51),
      clamp,
    );
    const colour = Float64Array.of(100, 50, 10);
    sampler.tint(0.5, 0.5, footprintOf([0, 0, 0, 0]), colour);
    [20, 10, 0].forEach((value, i) => expect(colour[i]).toBeCloseTo(value));
  });
});

describe('halved', () => {
  it('takes the means of four pixels, and of fewer where there are no more', () => {
    expect([...halved(rasterOf(2, 2, (x, y) => 4 * x + 8 * y)).rgb]).toEqual([6, 6, 0]);
    expect([...halved(rasterOf(1, 2, (_, y) => 8 * y)).rgb]).toEqual([4, 4, 0]);
    expect(halved(rasterOf(5, 1, () => 7))).toEqual({
      width: 2,
      height: 1,
      rgb: Uint8Array.of(7, 7, 0, 7, 7, 0),
    });
  });
});

describe('footprintOf', () => {
  it('finds the longer and the shorter way across what a dot shows', () => {
    const turned = Math.SQRT1_2;
    const { level, long, short } = footprintOf([6 * turned, 6 * turned, -2 * turned, 2 * turned]);
    expect(level).toBe(1);
    expect(Math.hypot(long[0], long[1])).toBeCloseTo(6);
    expect(Math.abs(long[0])).toBeCloseTo(Math.abs(long[1]));
    expect(Math.hypot(short[0], short[1])).toBeCloseTo(2);
    expect([long[2], short[2]]).toEqual([3, 1]);
  });

  it('stays finite for faces without area', () => {
    const { level, long, short } = footprintOf([0, 0, 0, 0]);
    expect(level).toBe(0);
    expect([...long, ...short].every(Number.isFinite)).toBe(true);
  });
});
