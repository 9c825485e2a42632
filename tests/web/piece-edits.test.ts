/** Edits of single pieces: what they do, and that the engine lays pieces where the studio says that they can lie. */
import { describe, expect, it } from 'vitest';
import { makeDoor } from '../../web/api/door.js';
import type { Session } from '../../web/api/session.js';
import { editWords, touchedParts } from '../../web/app/edit-words.js';
import type { JobResult } from '../../web/model/job.js';
import { isPinOf, joinOffers, layingOf, placing } from '../../web/model/piece-edits.js';
import { placeOf } from '../../web/model/piece-shape.js';
import { SheetPieces } from '../../web/model/sheet-pieces.js';
import { english } from '../../web/words/en/index.js';
import { boxAndLidResult } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { readRenderer } from './printed.js';
import { Dice } from './random-edits.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

describe('edits of a piece', () => {
  const result = boxAndLidResult();
  const [, lid] = result.pieces;
  const place = placeOf(lid!);

  it('are told by what they change', () => {
    expect(layingOf(lid!, place)).toBe('kept');
    expect(layingOf(lid!, { ...place, x: place.x + 1 })).toBe('moved');
    expect(layingOf(lid!, { ...place, sheet: 0 })).toBe('moved');
    expect(layingOf(lid!, { ...place, x: place.x + 1, turn: 5 })).toBe('turned');
  });

  it('have words in the history', () => {
    const words = (at: typeof place) => editWords(english, [placing(1, at)], result);
    expect(words({ ...place, x: 99 })).toBe('moved B');
    expect(words({ ...place, turn: 90 })).toBe('turned B');
    expect(words(place)).toBe('kept B in place');
    expect(editWords(english, [{ kind: 'unpin', piece: 2 }], result)).toBe('let B move');
    expect(editWords(english, [placing(7, place)], result)).toBe('moved a piece');
  });

  it('touch the part of their piece', () => {
    expect(touchedParts(result, result, [placing(1, place)])).toEqual([1]);
  });

  it('join a part with those that it touches alone', () => {
    expect(joinOffers(result, 0)).toEqual([{ part: 1, pieces: ['B'] }]);
    expect(joinOffers(result, 1)).toEqual([{ part: 0, pieces: ['A'] }]);
    const alone = { ...result, parts: 1, labels: result.labels.map(() => 0) };
    expect(joinOffers(alone, 0)).toEqual([]);
  });
});

const margin = 10;
const options = { parts: 4, height: 90, compact: 'off', runs: 40, margin, proxy: 0 } as const;

async function withRing(work: (session: Session) => Promise<void>): Promise<void> {
  const bytes = new TextEncoder().encode(objText(wavyRing(10)));
  const noFont = (): Promise<Uint8Array> => Promise.reject(new Error('nothing is drawn'));
  await withThreads(1, async (pool) => {
    const door = makeDoor({ startPool: () => pool, loadFont: noFont, loadRenderer: readRenderer });
    const session = await door.open([{ name: 'ring.obj', bytes }], { pool });
    await session.run(options);
    await work(session);
  });
}

const placesOf = ({ pieces }: JobResult) => pieces.map(placeOf);

/** Whether two places are the same but for rounding. */
function expectPlaces(found: ReturnType<typeof placesOf>, wanted: typeof found): void {
  expect(found.map(({ sheet }) => sheet)).toEqual(wanted.map(({ sheet }) => sheet));
  found.forEach(({ x, y, turn }, i) => {
    const other = wanted[i]!;
    expect(Math.hypot(x - other.x, y - other.y)).toBeLessThan(1e-6);
    expect(Math.abs(Math.sin(((turn - other.turn) * Math.PI) / 360))).toBeLessThan(1e-9);
  });
}

describe.skipIf(!isEngineBuilt)('pieces that are laid by hand', () => {
  it('lie where the studio finds no fault, and all others stay', () =>
    withRing(async (session) => {
      const dice = new Dice(11);
      let made = 0;
      for (let i = 0; i < 60 && made < 12; ++i) {
        const result = await session.result();
        const pieces = new SheetPieces(result, margin);
        const piece = dice.below(result.pieces.length);
        const { left, bottom, right, top } = pieces.room(0);
        const wanted = pieces.shape(piece).turnedBy(
          {
            ...placeOf(result.pieces[piece]!),
            sheet: dice.below(result.sheets.length),
            x: left + dice.roll() * (right - left),
            y: bottom + dice.roll() * (top - bottom),
          },
          dice.of([0, 90, 15, -37]),
        );
        const place = pieces.freePlace(piece, wanted);
        if (!place) continue;
        ++made;
        const applied = await session.apply(placing(piece, place));
        expect(applied, JSON.stringify({ piece, place })).toMatchObject({ ok: true });
        const after = await session.result();
        expect(after.sheets.length).toBeLessThanOrEqual(result.sheets.length);
        expectPlaces(
          placesOf(after),
          placesOf(result).map((before, at) => (at === piece ? place : before)),
        );
      }
      expect(made).toBe(12);
    }));

  it('go on a sheet to come without moving others, and pins add up', () =>
    withRing(async (session) => {
      const before = await session.result();
      const next = before.sheets.length;
      for (const [turn, piece] of [0, 1].entries()) {
        const pieces = new SheetPieces(await session.result(), margin);
        const wanted = { ...placeOf(before.pieces[piece]!), sheet: next + turn, x: 10, y: 10 };
        const place = pieces.freePlace(piece, wanted)!;
        expect(await session.apply(placing(piece, place))).toMatchObject({ ok: true });
        const after = await session.result();
        expect(after.pieces[piece]).toMatchObject({ sheet: next + turn });
        const others = (result: JobResult) => placesOf(result).slice(2);
        expectPlaces(others(after), others(before));
      }
      const { wishes, result } = await session.state();
      const pinned = result.pieces.filter((piece) =>
        wishes.pins.some((pin) => isPinOf(pin, piece)),
      );
      expect(pinned.map(({ name }) => name)).toEqual(['A', 'B']);
    }));

  it('cannot lie on another one that was laid by hand, as the studio says as well', () =>
    withRing(async (session) => {
      const first = await session.result();
      const { ok } = await session.apply(placing(0, placeOf(first.pieces[0]!)));
      expect(ok).toBe(true);
      const result = await session.result();
      const { sheet, x, y } = placeOf(result.pieces[0]!);
      const onTop = { ...placeOf(result.pieces[1]!), sheet, x, y };
      const pieces = new SheetPieces(result, margin);
      const place = pieces.pulledIn(1, onTop);
      expect(pieces.faultAt(1, place)).toEqual({ what: 'overlap', piece: 0 });
      expect(await session.apply(placing(1, place))).toMatchObject({ ok: false, code: 'bad-pin' });
    }));
});
