import { describe, expect, it } from 'vitest';
import { fitOf } from '../../web/export/model-picture.js';
import { ModelViews } from '../../web/export/model-views.js';
import { middlesOf, placeLetters } from '../../web/export/picture-letters.js';
import type { Point } from '../../web/export/point.js';
import { boxAndLidResult } from './fixtures.js';

const frame = { left: 20, bottom: 30, width: 60, height: 60 };

describe('letters in pictures', () => {
  it('stand in the middle of what is seen of their piece', () => {
    const views = new ModelViews(boxAndLidResult());
    const { areas, view } = views.from('front-left');
    const found = middlesOf(views, areas, fitOf(views, view, frame), frame);
    expect([...found.keys()].sort()).toEqual([0, 1]);
    for (const { at, radius } of found.values()) {
      expect(radius).toBeGreaterThan(5);
      expect(at[0] - radius).toBeGreaterThan(frame.left - 1);
      expect(at[1] + radius).toBeLessThan(frame.bottom + frame.height + 1);
    }
  });

  it('stand beside the picture where they do not go onto their piece, and do not overlap', () => {
    const found = new Map(
      Array.from({ length: 20 }, (_, piece): [number, { at: Point; radius: number }] => [
        piece,
        { at: [piece % 2 === 0 ? 30 : 70, 60 + piece / 10], radius: piece === 0 ? 9 : 0.5 },
      ]),
    );
    const names = [...found.keys()].map((piece) => `P${piece}`);
    const letters = placeLetters(found, names, { frame, side: 12, size: 3 });
    expect(letters).toHaveLength(20);
    expect(letters.filter(({ anchor }) => anchor === null).map(({ piece }) => piece)).toEqual([0]);
    for (const x of [0, 1]) {
      const column = letters.filter(({ anchor, piece }) => anchor && piece % 2 === x);
      const heights = column.map(({ at }) => at[1]).sort((a, b) => a - b);
      heights.slice(1).forEach((y, i) => expect(y - heights[i]!).toBeGreaterThan(3));
      expect(heights[0]).toBeGreaterThan(frame.bottom);
      expect(heights.at(-1)).toBeLessThan(frame.bottom + frame.height);
      const isOutside = ({ at }: { at: Point }) => (x === 0 ? at[0] < 20 : at[0] > 80);
      expect(column.every(isOutside)).toBe(true);
    }
  });

  it('leave out what has no room in the columns', () => {
    const found = new Map(
      Array.from({ length: 90 }, (_, piece): [number, { at: Point; radius: number }] => [
        piece,
        { at: [30, 60], radius: 0.1 },
      ]),
    );
    const names = [...found.keys()].map(String);
    expect(placeLetters(found, names, { frame, side: 12, size: 3 })).toHaveLength(14);
  });
});
