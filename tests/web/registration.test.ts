import { describe, expect, it } from 'vitest';
import { piecesInQuietZones, registrationMarks } from '../../web/export/registration.js';
import type { Point } from '../../web/export/point.js';
import type { SheetDrawing } from '../../web/export/sheet-drawing.js';

/** Sides of sheets, and how far apart marks are with the default insets of the Inkscape driver. */
const sheets: [string, number, number, number, number][] = [
  ['A4', 210, 297, 190, 277],
  ['A4 across', 297, 210, 277, 190],
  ['Letter', 215.9, 279.4, 195.9, 259.4],
];

/** A sheet with one square piece. */
function sheetWith([x, y]: Point, side: number): SheetDrawing {
  const cut: Point[] = [
    [x, y],
    [x + side, y],
    [x + side, y + side],
    [x, y + side],
  ];
  const none = { mountains: [], valleys: [], guides: [], flaps: [], texts: [] };
  const frame = { strokes: [], texts: [] };
  const piece = { letter: 'A', cuts: [cut], hasTape: false, ground: [], ...none };
  return { width: 210, height: 297, pieces: [piece], frame };
}

describe('registrationMarks', () => {
  it.each(sheets)('are those of the driver on %s', (_, width, height, across, up) => {
    const { square, corners, width: line } = registrationMarks(width, height);
    const top = height - 10;
    expect(line).toBe(0.3);
    const xs = square.map(([x]) => x);
    const ys = square.map(([, y]) => y);
    expect([Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)]).toEqual([
      10,
      15,
      top - 5,
      top,
    ]);
    const [right, lower] = corners;
    expect(right).toEqual([
      [width - 30, top],
      [width - 10, top],
      [width - 10, top - 20],
    ]);
    expect(lower).toEqual([
      [30, 10],
      [10, 10],
      [10, 30],
    ]);
    expect(right![1]![0] - lower![1]![0]).toBeCloseTo(across, 9);
    expect(right![1]![1] - lower![1]![1]).toBeCloseTo(up, 9);
  });
});

describe('piecesInQuietZones', () => {
  it.each<[string, Point, number, string[]]>([
    ['on the square', [12, 280], 20, ['A']],
    ['within the zone of a corner', [182, 270], 5, ['A']],
    ['around a whole zone', [5, 5], 100, ['A']],
    ['where there is no mark', [185, 5], 20, []],
    ['beside all zones', [30, 30], 150, []],
  ])('finds a piece %s', (_, at, side, expected) => {
    expect(piecesInQuietZones(sheetWith(at, side))).toEqual(expected);
  });
});
