import { describe, expect, it } from 'vitest';
import { sizeOption } from '../../web/element/viewer/target-size.js';
import { BadOption } from '../../web/words/bad-option.js';

/** Two corners of a box. */
const box = (x: number, y: number, z: number): number[] => [1, 1, 1, 1 + x, 1 + y, 1 + z];

describe('sizeOption', () => {
  it('is about the longest side', () => {
    expect(sizeOption('120', box(3, 2, 1))).toEqual({ width: 120 });
    expect(sizeOption(' 80.5 ', box(2, 3, 1))).toEqual({ height: 80.5 });
    expect(sizeOption('9', box(1, 2, 3))).toEqual({ depth: 9 });
  });

  it('takes the first of equal sides', () => {
    expect(sizeOption('50', box(2, 2, 2))).toEqual({ width: 50 });
  });

  it.each(['', 'big', '0', '-5', '1e9', '12cm'])('refuses %j by its own name', (written) => {
    const size = (): unknown => sizeOption(written, box(1, 1, 1));
    expect(size).toThrow(BadOption);
    expect(size).toThrow(/target-size/);
  });
});
