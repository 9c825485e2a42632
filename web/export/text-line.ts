import type { PieceLabel } from '../model/job.js';
import type { Point, Segment } from './point.js';

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
  /** A line below it says which way up it is read. */
  underlined?: boolean;
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

/** Figures that are figures when they are turned by half a turn, and which ones. */
const turnedFigures: Readonly<Record<string, string>> = { 0: '0', 1: '1', 6: '9', 8: '8', 9: '6' };

/** Whether a text of figures alone is another number when it is turned by half a turn, such as 6 or 68. */
export function isAmbiguous(text: string): boolean {
  if (!/^[01689]+$/.test(text)) return false;
  const turned = [...text].reverse().map((figure) => turnedFigures[figure]);
  // No number begins with 0.
  return turned[0] !== '0' && turned.join('') !== text;
}

/**
 * Of a line below a text: its middle below the baseline and its width, over the size of the font; so
 * the gap between is about as wide as the line.
 */
const underline = { drop: 0.11, width: 0.07 } as const;

/** Figures and the line below them are as high together as larger figures alone: the box of a label holds both. */
const underlinedShare = capHeight / (capHeight + underline.drop + underline.width / 2);

/** Width of a figure over the size of the font, in faces such as Helvetica and Noto Sans. */
const figureWidth = 0.56;

/** The line below an underlined text, with ends that may be round, and its width in mm. */
export function underlineOf({ text, at, angle, size }: TextLine): { line: Segment; width: number } {
  const width = underline.width * size;
  const half = (figureWidth * size * text.length - width) / 2;
  const [cosine, sine] = directionOf(angle);
  const down = underline.drop * size;
  const on = (along: number): Point => [
    at[0] + along * cosine + down * sine,
    at[1] + along * sine - down * cosine,
  ];
  return { line: [on(-half), on(half)], width };
}

/** A box around a text that stands upright, from one corner to the next. */
export function walkAround({ text, at: [x, y], anchor, size }: TextLine): Point[] {
  const width = widthAtMost(text, size);
  const left = anchor === 'start' ? x : x - width / 2;
  const [right, top] = [left + width, y + capHeight * size];
  return [
    [left, y],
    [right, y],
    [right, top],
    [left, top],
  ];
}

/** The text of a label, whose place is the middle of its box; underlined where it could be read upside down. */
export function centredLine({ text, x, y, angle, size }: PieceLabel): TextLine {
  const underlined = isAmbiguous(text);
  const letters = underlined ? underlinedShare * size : size;
  // From the middle of the box to the baseline.
  const drop = capHeight * (letters - size / 2);
  const [cosine, sine] = directionOf(angle);
  const at: Point = [x + drop * sine, y - drop * cosine];
  const line: TextLine = { text: cleaned(text), at, anchor: 'middle', angle, size: letters };
  return underlined ? { ...line, underlined } : line;
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
