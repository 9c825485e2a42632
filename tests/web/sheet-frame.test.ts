import { describe, expect, it } from 'vitest';
import { frameSheet } from '../../web/export/sheet-frame.js';
import { bandOf } from '../../web/model/sheet-room.js';
import { FreeSpace } from '../../web/export/free-space.js';
import { widthAtMost, type TextLine } from '../../web/export/text-line.js';
import { paperSizes } from '../../web/model/paper.js';
import { english } from '../../web/words/en/index.js';
import type { Point } from './sheet-file.js';

/** Corners of the box that a text takes at most. */
function cornersOf({ text, at: [x, y], anchor, angle, size }: TextLine): Point[] {
  const width = widthAtMost(text, size);
  const from = anchor === 'middle' ? -width / 2 : 0;
  const box: Point[] = [
    [from, -0.2 * size],
    [from + width, 0.72 * size],
  ];
  return box.map(([u, v]): Point => (angle === 90 ? [x - v, y + u] : [x + u, y + v]));
}

describe('frameSheet', () => {
  const margins = [0, 2.5, 4, 5, 9.5, 10, 20];
  const sheets = paperSizes.flatMap(({ name, width, height }) => [
    { name, width, height },
    { name: `${name} sideways`, width: height, height: width },
  ]);

  it.each(sheets)('keeps off the pieces and the edge: $name', ({ width, height }) => {
    for (const margin of margins) {
      const { from, to } = bandOf(margin);
      const words = { title: 'A long name '.repeat(9), note: 'n'.repeat(30), words: english };
      const { strokes, texts } = frameSheet({ width, height, margin, ...words, ends: 0, inset: 0 });
      const boxes = [...strokes.map(({ points }) => points), ...texts.map(cornersOf)];
      for (const points of boxes) {
        const low = [0, 1].map((k) => Math.min(...points.map((point) => point[k]!)));
        const high = [0, 1].map((k) => Math.max(...points.map((point) => point[k]!)));
        expect(Math.min(...low)).toBeGreaterThanOrEqual(from);
        expect(high[0]).toBeLessThanOrEqual(width - margin);
        expect(high[1]).toBeLessThanOrEqual(height - margin);
        // In the band at the left or in that below.
        expect(Math.min(...high)).toBeLessThanOrEqual(to);
      }
      expect(strokes.filter(({ closed }) => closed)).toHaveLength(1);
      expect(texts.filter(({ text }) => text === '50 mm')).toHaveLength(2);
      expect(texts.map(({ text }) => text)).toEqual(
        expect.arrayContaining(['this side', 'is outside']),
      );
    }
  });

  it('has shorter rulers on small paper', () => {
    const plan = {
      width: 90,
      height: 60,
      margin: 5,
      title: 'box',
      note: 'sheet 1 of 1',
      ends: 0,
      inset: 0,
    };
    const { texts } = frameSheet({ ...plan, words: english });
    const mark = ['this side', 'is outside'];
    const words = ['40 mm', '5 mm', '10 mm', ...mark, 'box', 'sheet 1 of 1'];
    expect(texts.map(({ text }) => text)).toEqual(words);
  });
});

describe('FreeSpace', () => {
  const area = { left: 10, bottom: 10, right: 110, top: 110 };
  const square: Point[] = [
    [30, 10],
    [110, 10],
    [110, 110],
    [30, 110],
  ];

  it('finds the lowest place, and of these the rightmost', () => {
    expect(new FreeSpace(area, [], 2).place(40, 20)).toEqual([70, 10]);
  });

  it('keeps its distance', () => {
    const [x] = new FreeSpace(area, [square], 2).place(15, 20)!;
    expect(x + 15).toBeLessThanOrEqual(28);
    expect(new FreeSpace(area, [square], 2).place(20, 20)).toBeNull();
  });

  it('does not look into holes that are too small', () => {
    const hole: Point[] = [
      [50, 50],
      [50, 70],
      [70, 70],
      [70, 50],
    ];
    const all: Point[] = [
      [10, 10],
      [110, 10],
      [110, 110],
      [10, 110],
    ];
    const space = new FreeSpace(area, [all, hole], 2);
    expect(space.place(17, 17)).toBeNull();
    expect(space.place(13, 13)).not.toBeNull();
  });
});
