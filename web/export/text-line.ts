import type { PieceLabel } from '../model/job.js';
import type { Point } from './point.js';

/** A short text on a sheet; mm, y up, from the sheet's lower left. */
export interface TextLine {
  text: string;
  /** Where its baseline begins, or the middle of it. */
  at: Point;
  anchor: 'start' | 'middle';
  /** Of its baseline, counter-clockwise from the right; degrees. */
  angle: number;
  /** Of the font. */
  size: number;
}

/** Height of capitals and digits of a sans-serif face over the size of the font. */
export const capHeight = 0.72;

/**
 * Cosine and sine of a text's angle, to a millionth: the functions' last digits differ between
 * browsers, and files do not.
 */
export function directionOf(angle: number): [cosine: number, sine: number] {
  const turn = (angle * Math.PI) / 180;
  return [Math.round(1e6 * Math.cos(turn)) / 1e6, Math.round(1e6 * Math.sin(turn)) / 1e6];
}

/**
 * One line of composed letters, so that the same name is the same letters from any system; without
 * what no file may hold.
 */
export function cleaned(text: string): string {
  return text.normalize('NFC').replace(/[\p{Cc}\p{Cs}\uFFFE\uFFFF]+/gu, ' ');
}

/** The text of a label, whose place is the middle of its box. */
export function centredLine({ text, x, y, angle, size }: PieceLabel): TextLine {
  const drop = (size * capHeight) / 2;
  const [cosine, sine] = directionOf(angle);
  const at: Point = [x + drop * sine, y - drop * cosine];
  return { text: cleaned(text), at, anchor: 'middle', angle, size };
}

/** Widths over the size of the font that no common sans-serif face exceeds; the first that applies. */
const widths: readonly [letters: RegExp, width: number][] = [
  [/[ .,:;'!/()ijl·-]/, 0.4],
  [/[mwMW@%—…]/, 1],
  [/[A-Z]/, 0.8],
  [/[\da-z]/, 0.66],
  [/[\0-\u2e7f]/, 0.95],
];

/** Width of a text in mm, at most, whatever sans-serif face it is written in. */
export function widthAtMost(text: string, size: number): number {
  const widthOf = (letter: string): number =>
    widths.find(([letters]) => letters.test(letter))?.[1] ?? 1;
  return size * [...text].reduce((sum, letter) => sum + widthOf(letter), 0);
}

/** The text, or as much of its beginning as fits, with an ellipsis. */
export function shortened(text: string, size: number, room: number): string {
  if (widthAtMost(text, size) <= room) return text;
  const letters = [...text];
  while (letters.length > 0 && widthAtMost(`${letters.join('')}…`, size) > room) letters.pop();
  return letters.length > 0 ? `${letters.join('').trimEnd()}…` : '';
}
