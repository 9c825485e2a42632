import { expect, test } from 'vitest';
import { isRangeFault, parseSheetRange } from '../../web/model/sheet-range.js';

test.each([
  ['2', [1]],
  ['1-3, 5', [0, 1, 2, 4]],
  ['3 - 1', [0, 1, 2]],
  ['5;2,2 , 2–3', [1, 2, 4]],
  [' 6 ', [5]],
])('"%s" chooses sheets', (text, sheets) => {
  expect(parseSheetRange(text, 6)).toEqual(sheets);
});

test.each(['', '  ', ',', '1-6', '1,2,3,4,5,6'])('"%s" chooses all of them', (text) => {
  expect(parseSheetRange(text, 6)).toBeNull();
});

test.each([
  ['a', 'unreadable'],
  ['1-', 'unreadable'],
  ['1--2', 'unreadable'],
  ['1.5', 'unreadable'],
  ['-1', 'unreadable'],
  ['1-2-3', 'unreadable'],
  ['99999', 'unreadable'],
  ['0', 'beyond'],
  ['7', 'beyond'],
  ['5-9', 'beyond'],
])('"%s" chooses none: %s', (text, fault) => {
  const range = parseSheetRange(text, 6);
  expect(range).toBe(fault);
  expect(isRangeFault(range)).toBe(true);
});
