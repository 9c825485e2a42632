import { expect, test } from 'vitest';
import {
  allInView,
  clampedWidth,
  oneInView,
  scrollTo,
  shareAt,
  wheelFactor,
  widthRange,
} from '../../web/view/zoom.js';

const gaps = { between: 24, caption: 28 };
const a4 = { width: 210, height: 297 };

test('what lies at a place stays there when its box gets larger and is scrolled', () => {
  const at = { x: 130, y: 70 };
  const before = { left: 100, top: 50, width: 200, height: 300 };
  const share = shareAt(before, at);
  // Laid out anew, a box may lie elsewhere.
  const after = { left: 40, top: 90, width: 500, height: 750 };
  const { x, y } = scrollTo(after, share, at);
  const scrolled = { ...after, left: after.left - x, top: after.top - y };
  expect(shareAt(scrolled, at)).toEqual(share);
  expect([x, y]).toEqual([40 + 0.15 * 500 - 130, 90 + (20 / 300) * 750 - 70]);
});

test('a notch of the wheel and one back come to nothing, and no turn is a jump', () => {
  const turned = (deltaY: number, deltaMode = 0): number => wheelFactor({ deltaY, deltaMode });
  expect(turned(-100)).toBeCloseTo(1.15);
  expect(turned(100) * turned(-100)).toBeCloseTo(1);
  // Three lines are about a notch.
  expect(turned(-3, 1)).toBeCloseTo(1.15, 1);
  expect(turned(-100_000)).toBe(turned(-300));
});

test('sizes have bounds', () => {
  expect(clampedWidth(1)).toBe(widthRange.least);
  expect(clampedWidth(1e6)).toBe(widthRange.most);
  expect(clampedWidth(500)).toBe(500);
});

test('one whole sheet fits by whichever of its sides is tighter', () => {
  const one = { count: 5, ...a4 };
  expect(oneInView(one, { width: 300, height: 2000, gaps })).toBe(300);
  expect(oneInView(one, { width: 2000, height: 322, gaps })).toBeCloseTo((294 * 210) / 297);
  // Where the page is scrolled there is no height to fit into.
  expect(oneInView(one, { width: 358, height: null, gaps })).toBe(358);
});

test('all sheets are arranged so that they are seen as large as possible', () => {
  const room = { width: 1000, height: 600, gaps };
  expect(allInView({ count: 1, ...a4 }, room)).toEqual({
    columns: 1,
    width: oneInView({ count: 1, ...a4 }, room),
  });
  for (const count of [2, 3, 6, 7, 12, 40]) {
    const { columns, width } = allInView({ count, ...a4 }, room);
    const rows = Math.ceil(count / columns);
    const height = (width * 297) / 210 + gaps.caption;
    expect(columns * width + (columns - 1) * gaps.between).toBeLessThanOrEqual(1000.001);
    expect(rows * height + (rows - 1) * gaps.between).toBeLessThanOrEqual(600.001);
    // With one column more or less they would be smaller.
    for (const other of [columns - 1, columns + 1].filter((number) => number >= 1)) {
      const lines = Math.ceil(count / other);
      const across = (1000 - (other - 1) * gaps.between) / other;
      const down = (600 - (lines - 1) * gaps.between) / lines - gaps.caption;
      expect(Math.min(across, (down * 210) / 297)).toBeLessThanOrEqual(width + 0.001);
    }
  }
});
