/** Pieces on their way, in a hand or step by step, and what is said of it. */
import { describe, expect, it } from 'vitest';
import { cannotStay, notDropped, pieceWords } from '../../web/app/piece-words.js';
import { Hover } from '../../web/view/hover.js';
import { PieceMove } from '../../web/model/piece-move.js';
import { SheetPieces } from '../../web/model/sheet-pieces.js';
import { english } from '../../web/words/en/index.js';
import { boxAndLidResult } from './fixtures.js';

/** The open box at (10, 20), 160 x 80 mm, and its lid at (150, 200), 40 x 40 mm. */
function boxAndLid(): SheetPieces {
  const result = boxAndLidResult();
  const [box, lid] = result.pieces;
  result.pieces[0] = { ...box!, x: 10, y: 20 };
  result.pieces[1] = { ...lid!, sheet: 0, x: 150, y: 200 };
  return new SheetPieces(result, 10);
}

describe('a piece on its way', () => {
  it('keeps the hand where it took it, and snaps to margins', () => {
    const move = new PieceMove(boxAndLid(), 1);
    expect([move.isAway, move.fault]).toEqual([false, null]);
    move.grab({ sheet: 0, point: [155, 210] });
    move.follow({ sheet: 0, point: [145.3, 190.4] }, 2);
    expect(move.place).toMatchObject({ sheet: 0, x: 140, y: 180 });
    move.follow({ sheet: 0, point: [164.2, 190] }, 2);
    expect(move.place).toMatchObject({ x: 160, y: 180 });
    expect([move.isAway, move.fault]).toEqual([true, null]);
    move.follow({ sheet: 0, point: [60, 70] }, 2);
    expect(move.fault).toEqual({ what: 'overlap', piece: 0 });
    move.follow({ sheet: 1, point: [60, 70] }, 2);
    expect([move.place.sheet, move.fault]).toEqual([1, null]);
  });

  it('turns in the hand about its middle, and else stays within the margins', () => {
    const pieces = boxAndLid();
    const held = new PieceMove(pieces, 0);
    held.grab({ sheet: 0, point: [90, 60] });
    held.turn(90);
    expect([held.place.x, held.place.y]).toEqual([expect.closeTo(50), expect.closeTo(-20)]);
    expect(held.fault).toEqual({ what: 'outside' });
    // The hand goes on holding it where it is then.
    held.follow({ sheet: 0, point: [90, 60] }, 0);
    expect([held.place.x, held.place.y]).toEqual([expect.closeTo(50), expect.closeTo(-20)]);
    const stepping = new PieceMove(pieces, 0);
    stepping.turn(90);
    expect(stepping.place.y).toBeCloseTo(10);
    expect(stepping.fault).toBeNull();
  });

  it('goes by steps, and comes back', () => {
    const move = new PieceMove(boxAndLid(), 1);
    move.nudge(1, 0);
    move.nudge(0, -10);
    expect(move.place).toMatchObject({ x: 151, y: 190 });
    move.nudge(-1, 10);
    expect(move.isAway).toBe(false);
  });

  it('finds room on a sheet, also turned, or none', () => {
    const pieces = boxAndLid();
    const move = new PieceMove(pieces, 0);
    expect(move.findRoom(3)).toBe(true);
    expect(move.place).toMatchObject({ sheet: 3, x: 10, y: 20, turn: 0 });
    const narrow = pieces.result.sheets.map(() => ({ width: 110, height: 297 }));
    const upright = new PieceMove(new SheetPieces({ ...pieces.result, sheets: narrow }, 10), 0);
    expect(upright.findRoom(1)).toBe(true);
    expect(upright.place.turn).toBe(90);
    const small = pieces.result.sheets.map(() => ({ width: 90, height: 90 }));
    const nowhere = new PieceMove(new SheetPieces({ ...pieces.result, sheets: small }, 10), 0);
    expect(nowhere.findRoom(1)).toBe(false);
    expect(nowhere.isAway).toBe(false);
  });
});

describe('words for pieces', () => {
  const pieces = boxAndLid();

  it('say what a piece is, and why it cannot lie somewhere', () => {
    expect(pieceWords(english, pieces, 0)).toBe('Piece A: 160 × 80 mm, sheet 1, 10 faces');
    expect(cannotStay(english, pieces, 1, { what: 'overlap', piece: 0 })).toBe(
      'B cannot stay here: it would lie on A.',
    );
    expect(notDropped(english, pieces, 1, { what: 'outside' })).toBe(
      'B is back where it was. There, it would be too near to the edge of the sheet to be printed.',
    );
    expect(english.pieces.noRoom('B', 2)).toBe(
      'There is no room for B on sheet 2. Move another piece away first.',
    );
  });

  it('say what was done with it', () => {
    expect(english.pieces.laid.moved('B')).toBe('Moved B.');
    expect(english.pieces.laid.turned('B')).toBe('Turned B.');
    expect(english.pieces.laid.kept('B')).toBe('B stays here now, whatever else moves.');
  });
});

describe('what is under the mouse', () => {
  it('is asked for one place after the other, and of these the last', () => {
    const asked: number[] = [];
    const hover = new Hover((x) => asked.push(x));
    for (const x of [1, 2, 3]) hover.ask({ x, y: 0 });
    expect(asked).toEqual([1]);
    expect(hover.answered()).toBe(true);
    expect(asked).toEqual([1, 3]);
    // An answer that comes after the mouse has left is of no use.
    hover.end();
    expect(hover.answered()).toBe(false);
    expect(asked).toEqual([1, 3]);
  });
});
