import { describe, expect, it } from 'vitest';
import { FontSet } from '../../web/export/font-set.js';
import { centredLine, shortened, widthAtMost } from '../../web/export/text-line.js';
import { pieceLetter } from './piece-letter.js';
import { fontReader } from './printed.js';

describe('pieceLetter', () => {
  it('counts like the columns of a table', () => {
    const letters = [0, 1, 25, 26, 27, 51, 52, 701, 702].map(pieceLetter);
    expect(letters).toEqual(['A', 'B', 'Z', 'AA', 'AB', 'AZ', 'BA', 'ZZ', 'AAA']);
  });
});

describe('centredLine', () => {
  const label = { text: '17', x: 50, y: 40, size: 5 };

  it('has its baseline below the middle of upright text', () => {
    expect(centredLine({ ...label, angle: 0 }).at).toEqual([50, 40 - 1.8]);
  });

  it('turns with the text', () => {
    const [x, y] = centredLine({ ...label, angle: 90 }).at;
    expect(x).toBeCloseTo(51.8, 9);
    expect(y).toBeCloseTo(40, 9);
  });
});

describe('widthAtMost', () => {
  it('is no less than what any letter takes in the fonts that come along', async () => {
    const letters = [
      ...Array.from({ length: 95 }, (_, i) => String.fromCharCode(32 + i)),
      ...'äöüßéñçøåæœÄÖÜŁžΩλЖщ°×·…—“”うさぎ折紙ー、。ｱ',
    ];
    const set = await FontSet.load(letters, fontReader());
    expect(set.missing).toEqual([]);
    for (const letter of letters) {
      const font = set.font(set.runs(letter)[0]!.slice);
      const { advanceWidth } = font.glyphForCodePoint(letter.codePointAt(0)!);
      expect(widthAtMost(letter, 1), letter).toBeGreaterThanOrEqual(advanceWidth / font.unitsPerEm);
    }
  });
});

describe('shortened', () => {
  it('leaves a text that fits', () => {
    expect(shortened('whale', 2, 20)).toBe('whale');
  });

  it('cuts a text that does not, and marks it', () => {
    const text = shortened('a very long name of a model', 2, 20);
    expect(text).toMatch(/^a very.*[^ ]…$/);
    expect(widthAtMost(text, 2)).toBeLessThanOrEqual(20);
    expect(shortened('whale', 2, 1)).toBe('');
  });
});
