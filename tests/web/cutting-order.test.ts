import { describe, expect, it } from 'vitest';
import { inCuttingOrder } from '../../web/export/cutting-order.js';
import type { Point } from '../../web/export/point.js';
import type { PieceDrawing } from '../../web/export/sheet-drawing.js';
import { Dice } from './random-edits.js';

/** A square, clockwise if it is a window. */
function square([x, y]: Point, side: number, isWindow = false): Point[] {
  const walk: Point[] = [
    [x, y],
    [x + side, y],
    [x + side, y + side],
    [x, y + side],
  ];
  return isWindow ? walk.reverse() : walk;
}

function pieceOf(letter: string, cuts: Point[][]): PieceDrawing {
  const none = { mountains: [], valleys: [], guides: [], flaps: [], texts: [] };
  return { letter, cuts, hasTape: false, ground: [], ...none };
}

const lettersOf = (pieces: PieceDrawing[]): string => pieces.map(({ letter }) => letter).join('');

describe('inCuttingOrder', () => {
  it('cuts windows before the outline around them', () => {
    const cuts = [square([0, 0], 50), square([5, 5], 10, true), square([20, 20], 20, true)];
    const [piece] = inCuttingOrder([pieceOf('A', cuts)], [0, 100]);
    expect(piece!.cuts).toEqual([cuts[1], cuts[2], cuts[0]]);
    expect(cuts[0]).toEqual(square([0, 0], 50));
  });

  it('cuts a piece in a window of another before that window', () => {
    const frame = pieceOf('A', [square([0, 0], 100), square([10, 10], 80, true)]);
    const ring = pieceOf('B', [square([20, 20], 60), square([30, 30], 40, true)]);
    const core = pieceOf('C', [square([40, 40], 20)]);
    // From where the outermost one is nearest.
    expect(lettersOf(inCuttingOrder([frame, ring, core], [0, 0]))).toBe('CBA');
    expect(lettersOf(inCuttingOrder([core, frame, ring], [0, 0]))).toBe('CBA');
  });

  it('goes on with the nearest piece, from the start of the blade', () => {
    const row = ['A', 'B', 'C', 'D'].map((letter, i) => pieceOf(letter, [square([i * 20, 0], 10)]));
    const mixed = [row[2]!, row[0]!, row[3]!, row[1]!];
    expect(lettersOf(inCuttingOrder(mixed, [0, 0]))).toBe('ABCD');
    expect(lettersOf(inCuttingOrder(mixed, [90, 0]))).toBe('DCBA');
  });

  it('keeps every piece of a sheet, each once', () => {
    for (let seed = 1; seed <= 20; ++seed) {
      const dice = new Dice(seed);
      const places = Array.from({ length: 30 }, (_, i): Point => [(i % 6) * 30, dice.below(200)]);
      const pieces = places.map((at, i) => pieceOf(String.fromCharCode(65 + i), [square(at, 9)]));
      const ordered = inCuttingOrder(pieces, [0, 297]);
      expect([...lettersOf(ordered)].sort().join(''), `seed ${seed}`).toBe(lettersOf(pieces));
    }
  });
});
