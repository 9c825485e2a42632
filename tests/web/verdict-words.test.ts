import { describe, expect, it } from 'vitest';
import { PlaceWalk } from '../../web/app/place-walk.js';
import { hopeless, noticeRemarks } from '../../web/app/result-words.js';
import { conclusionOf, findingsOn } from '../../web/model/verdict.js';
import { otherNotices, resultNotices } from '../../web/model/result-notices.js';
import { findingWords } from '../../web/words/verdict.js';
import { english } from '../../web/words/en/index.js';
import { scaled } from './changed-result.js';
import { boxAndLidResult } from './fixtures.js';

describe('the words of a verdict', () => {
  it('say in one line whether paper should be spent', () => {
    const of = (count: number, code: 'buildable' | 'hard' | 'not-buildable') =>
      english.verdict.headline({ code, level: 'green', count, params: {} }, count);
    expect(of(0, 'buildable')).toBe('Ready to print');
    expect(of(1, 'hard')).toBe('You can build it. Look at 1 thing first');
    expect(of(2, 'not-buildable')).toBe('Do not print it yet: nobody can build it like this');
    expect([english.verdict.good(1), english.verdict.good(7)]).toEqual([
      '1 thing is fine',
      '7 things are fine',
    ]);
  });

  it('have a line for each finding, whether it is good or bad', () => {
    const { model, ...result } = scaled(boxAndLidResult(), 0.09);
    const pieces = result.pieces.map(({ motion: _, ...piece }) => ({
      ...piece,
      x: 0,
      labels: [],
      overlaps: 1,
      necks: Float64Array.of(1),
      foldable: 'no' as const,
    }));
    const missing = { narrow: 8, thin: 0, blocked: 0, short: 0 };
    const flaps = { ...result.flaps, missing, wanted_mm: 20, missing_mm: 20 };
    const worse = { ...model, faces: new Int32Array(60) };
    const bad = findingsOn({ ...result, pieces, flaps, model: worse }, 10);
    const titles = [...bad, ...findingsOn(boxAndLidResult(), 10)].map(
      (finding) => findingWords(english.verdict, finding).title,
    );
    for (const title of titles) expect(title).toMatch(/^[A-Z0-9][^.]+$/);
    const words = bad
      .filter(({ level }) => level !== 'green')
      .map((finding) => Object.values(findingWords(english.verdict, finding)).join('. '));
    expect(words).toContain(
      '2 pieces lie on top of themselves. Nobody can cut out pieces A, B whole.',
    );
    expect(words).toContain(
      '8 edges to glue are too short. Half of all edges are at most 3.6 mm long: too small for any fingers.',
    );
    expect(words).toHaveLength(11);
  });

  it('take the place of the words of success where nobody can build it', () => {
    expect(hopeless(english, boxAndLidResult(), 10)).toBeNull();
    const tiny = scaled(boxAndLidResult(), 0.09);
    expect(conclusionOf(findingsOn(tiny, 10)).level).toBe('red');
    expect(hopeless(english, tiny, 10)).toBe('Do not print it yet: nobody can build it like this.');
    // A run that was cancelled tells how far it came.
    const [first] = tiny.pieces;
    expect(hopeless(english, { ...tiny, pieces: [first!] }, 10)).toBeNull();
  });

  it('are not said once more among the notices', () => {
    const notices = [{ code: 'meets-itself', params: { part: 2 } }];
    const result = { ...scaled(boxAndLidResult(), 0.09), notices };
    expect(resultNotices(result, 10, []).length).toBeGreaterThan(2);
    const others = noticeRemarks(english, otherNotices(resultNotices(result, 10, [])));
    expect(others).toHaveLength(1);
    expect(others[0]).toMatch(/^Part 2 has faces that run through each other/);
  });
});

describe('a walk through places', () => {
  it('begins with the first and goes round, in both directions', () => {
    const places = [{ piece: 4 }, { piece: 5 }, { piece: 6 }];
    const walk = new PlaceWalk('tiny-pieces', 'Tiny', places);
    expect([walk.step(1), walk.wordsIn(english)]).toEqual([{ piece: 4 }, 'Tiny: 1 of 3']);
    expect([walk.step(1), walk.wordsIn(english)]).toEqual([{ piece: 5 }, 'Tiny: 2 of 3']);
    expect(walk.step(-1)).toEqual({ piece: 4 });
    expect([walk.step(-1), walk.wordsIn(english)]).toEqual([{ piece: 6 }, 'Tiny: 3 of 3']);
    expect(walk.step(1)).toEqual({ piece: 4 });
  });

  it('goes on after a change where it was, or with the place after one that is gone', () => {
    const places = [{ piece: 4 }, { piece: 5 }, { piece: 6 }];
    const walk = new PlaceWalk('tiny-pieces', 'Tiny', places);
    walk.step(1);
    walk.step(1);
    const kept = walk.resumed('Two', [{ piece: 5 }, { piece: 6 }])!;
    expect(kept.wordsIn(english)).toBe('Two: 1 of 2');
    expect(kept.step(1)).toEqual({ piece: 6 });
    const mended = walk.resumed('Two', [{ piece: 4 }, { piece: 6 }])!;
    expect(mended.step(1)).toEqual({ piece: 6 });
    expect(walk.resumed('One', [{ piece: 4 }])!.step(1)).toEqual({ piece: 4 });
    expect(walk.resumed('None', [])).toBeNull();
  });

  it('does not count a single place', () => {
    const walk = new PlaceWalk('tiny-pieces', 'Tiny', [{ piece: 0 }]);
    expect([walk.step(1), walk.wordsIn(english), walk.isLong]).toEqual([
      { piece: 0 },
      'Tiny',
      false,
    ]);
  });
});
