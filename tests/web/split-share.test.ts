import { expect, test } from 'vitest';
import { clampedSplit, splitAfterKey, splitAt, splitRange } from '../../web/view/split-share.js';

test('keys move the border, and stop at its ends', () => {
  expect(splitAfterKey(40, 'ArrowRight', false)).toBe(42);
  expect(splitAfterKey(40, 'ArrowLeft', false)).toBe(38);
  expect(splitAfterKey(40, 'ArrowRight', true)).toBe(50);
  expect(splitAfterKey(69, 'ArrowRight', false)).toBe(splitRange.most);
  expect(splitAfterKey(25, 'ArrowLeft', true)).toBe(splitRange.least);
  expect(splitAfterKey(33, 'Home', false)).toBe(splitRange.least);
  expect(splitAfterKey(33, 'End', false)).toBe(splitRange.most);
  expect(splitAfterKey(33, 'Enter', false)).toBe(splitRange.usual);
  for (const key of ['Tab', 'a', 'ArrowUp']) expect(splitAfterKey(33, key, false)).toBeNull();
});

test('a hand draws the border to a place in its room', () => {
  const room = { left: 100, width: 1000 };
  expect(splitAt(600, room)).toBe(50);
  expect(splitAt(0, room)).toBe(splitRange.least);
  expect(splitAt(5000, room)).toBe(splitRange.most);
});

test('whatever was kept that is no share is forgotten', () => {
  expect(clampedSplit(Number('nonsense'))).toBe(splitRange.usual);
  expect(clampedSplit(Infinity)).toBe(splitRange.usual);
});
