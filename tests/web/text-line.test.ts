import { describe, expect, it } from 'vitest';
import { FontSet } from '../../web/export/font-set.js';
import {
  capHeight,
  centredLine,
  isAmbiguous,
  shortened,
  underlineOf,
  widthAtMost,
} from '../../web/export/text-line.js';
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

describe('isAmbiguous', () => {
  it('knows numbers that are others when they are turned', () => {
    for (const text of ['6', '9', '66', '99', '68', '89', '16', '18', '81', '91', '106', '1061']) {
      expect(isAmbiguous(text), text).toBe(true);
    }
  });

  it('leaves those that stay the same, or are none', () => {
    for (const text of ['1', '8', '11', '69', '96', '88', '101', '10', '60', '90', '680', '']) {
      expect(isAmbiguous(text), text).toBe(false);
    }
    for (const text of ['2', '36', '97', 'A6', 'C:9', '9°', '66 mm', 'Six']) {
      expect(isAmbiguous(text), text).toBe(false);
    }
  });

  it('knows every number below 10,000 by writing it upside down', () => {
    const turned = { 0: '0', 1: '1', 6: '9', 8: '8', 9: '6' } as Record<string, string>;
    for (let number = 1; number < 10_000; ++number) {
      const figures = [...String(number)].reverse().map((figure) => turned[figure] ?? ' ');
      const other = Number(figures.join(''));
      const isOther =
        !figures.includes(' ') && String(other).length === figures.length && other !== number;
      expect(isAmbiguous(String(number)), String(number)).toBe(isOther);
    }
  });
});

describe('underlined labels', () => {
  const label = { text: '68', x: 50, y: 40, size: 5 };
  const half = (5 * capHeight) / 2;

  it('keep figures and line within the box of the label', () => {
    const line = centredLine({ ...label, angle: 0 });
    expect(line.underlined).toBe(true);
    const { line: below, width } = underlineOf(line);
    expect(line.at[1] + capHeight * line.size).toBeCloseTo(40 + half, 9);
    expect(below[0][1] - width / 2).toBeCloseTo(40 - half, 9);
    // A gap that is seen: as wide as the line.
    expect(line.at[1] - (below[0][1] + width / 2)).toBeGreaterThan(width);
    expect(below[0][0] + below[1][0]).toBeCloseTo(100, 9);
    expect(below[1][0] - below[0][0]).toBeGreaterThan(line.size);
    expect(below[1][0] - below[0][0]).toBeLessThan(widthAtMost('68', line.size));
  });

  it('have it to the right of a text that is read from the right', () => {
    const { line: below, width } = underlineOf(centredLine({ ...label, angle: 90 }));
    expect(below[0][0] + width / 2).toBeCloseTo(50 + half, 5);
    expect(below[0][0]).toBeCloseTo(below[1][0], 9);
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
