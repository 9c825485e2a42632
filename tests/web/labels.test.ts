import { describe, expect, it } from 'vitest';
import { baselineOf } from '../../web/export/label.js';
import { pieceLetter } from '../../web/model/piece-letter.js';

describe('pieceLetter', () => {
  it('counts like the columns of a table', () => {
    const letters = [0, 1, 25, 26, 27, 51, 52, 701, 702].map(pieceLetter);
    expect(letters).toEqual(['A', 'B', 'Z', 'AA', 'AB', 'AZ', 'BA', 'ZZ', 'AAA']);
  });
});

describe('baselineOf', () => {
  const label = { text: '17', x: 50, y: 40, size: 5 };

  it('is below the middle of upright text', () => {
    expect(baselineOf({ ...label, angle: 0 })).toEqual([50, 40 - 1.8]);
  });

  it('turns with the text', () => {
    const [x, y] = baselineOf({ ...label, angle: 90 });
    expect(x).toBeCloseTo(51.8, 9);
    expect(y).toBeCloseTo(40, 9);
  });
});
