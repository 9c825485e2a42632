import { describe, expect, it } from 'vitest';
import { BadEdit, readEdits } from '../../web/api/read-edits.js';

function faultOf(value: unknown): BadEdit {
  try {
    readEdits(value);
  } catch (error) {
    if (error instanceof BadEdit) return error;
  }
  throw new Error('These edits were taken');
}

const good = { kind: 'split', part: 1, into: 2 };

describe('lists of edits', () => {
  it('are taken as they are', () => {
    const edits = [good, { kind: 'join', edge: [0, 1], search: true }];
    expect(readEdits(edits)).toBe(edits);
    expect(readEdits([])).toEqual([]);
  });

  it.each([
    [good, 'the edits are no list'],
    [[good, 7], 'edit 2 is no object'],
    [[{ kind: 'fold' }], /^edit 1 has the kind 'fold', which is none of split, merge, /],
    [[{ ...good, part: 0 }], "edit 1 (split): 'part' is not a whole number from 1 on"],
    [[{ kind: 'split', part: 1 }], "edit 1 (split): 'into' is not a whole number from 1 on"],
    [[{ ...good, faces: [] }], "edit 1 (split): there is no 'faces'"],
    [[{ kind: 'merge', parts: [1] }], "edit 1 (merge): 'parts' is not a list of 2 or more numbers"],
    [[{ kind: 'cut', edge: [1] }], "edit 1 (cut): 'edge' is not two vertices"],
    [
      [{ kind: 'join', edge: [0, 1], search: 1 }],
      "edit 1 (join): 'search' is neither true nor false",
    ],
    [
      [{ kind: 'lock', edge: [0, 1], as: 'glue' }],
      "edit 1 (lock): 'as' is none of fold, cut, free",
    ],
    [[{ kind: 'name', part: 1, text: 1 }], "edit 1 (name): 'text' is not a text"],
    [[{ kind: 'paper', options: [] }], "edit 1 (paper): 'options' has no options"],
    [
      [{ kind: 'place', piece: 1, sheet: 1, x_mm: NaN, y_mm: 0, turn_deg: 0 }],
      "edit 1 (place): 'x_mm' is not a number",
    ],
  ])('are refused in words: %j', (value, words) => {
    const { message } = faultOf(value);
    if (typeof words === 'string') expect(message).toBe(words);
    else expect(message).toMatch(words);
  });

  it('are refused by a code and parameters', () => {
    const { code, params } = faultOf([good, { ...good, into: 0 }]);
    expect(code).toBe('bad-edit');
    const place = { what: 'field', edit: 2, kind: 'split', field: 'into' };
    expect(params).toEqual({ ...place, expected: 'whole', least: 1 });
  });
});
