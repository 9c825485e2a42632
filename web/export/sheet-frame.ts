/**
 * What every sheet carries besides its pieces: a ruler along its lower and its left edge, a box to
 * measure, which side is the outside of the model, title and number, and how to print it. All of it lies beside the pieces by construction:
 * the engine keeps those bands free (`bandOf`).
 */
import { rulerLength, type LineKind } from '../model/print-options.js';
import { bandHeight, bandOf } from '../model/sheet-room.js';
import type { Words } from '../words/words.js';
import type { Point } from './point.js';
import { capHeight, shortened, widthAtMost, type TextLine } from './text-line.js';

/** A line of the frame; in a legend also a sample of another kind, or of the area of a flap. */
export interface Stroke {
  points: Point[];
  closed: boolean;
  sample?: LineKind | 'flap';
}

export interface SheetFrame {
  strokes: Stroke[];
  texts: TextLine[];
}

/** Where frame goes, and what it says. */
export interface SheetFramePlan {
  width: number;
  height: number;
  /** Of the sheet; mm. */
  margin: number;
  /** Two lines; the first may be shortened, the second is left out where it has no room. */
  title: string;
  note: string;
  /** What stays free at the far ends of both bands; mm. */
  ends: number;
  /** What the bands shall keep from the edge of the sheet; mm. */
  inset: number;
  words: Words;
}

// 6 points: small, but readable on every printer.
const textSize = 2.1;
// 4 points, for the box where there is no room for a larger one.
const smallSize = 1.4;
const boxHeight = 5;
const boxWidth = 20;
const gap = 3;
// Of a ruler's line to the edge of the band.
const lineRoom = 0.5;
// Baselines of title and note over the band's lower edge.
const [upperLine, lowerLine] = [3.1, 0.5];

/** Of the two lines of text in the band: baselines over its lower edge, size, and what stays free beside them; mm. */
export const bandLines = { upper: upperLine, lower: lowerLine, size: textSize, gap } as const;

/** A mark each mm, longer ones each 5 and 10. */
function tickHeight(at: number): number {
  if (at % 10 === 0) return 3;
  return at % 5 === 0 ? 2.2 : 1.4;
}

type Place = (point: Point) => Point;

/** Takes what is drawn from (0, 0) to the right to its place, where it may go up instead. */
function placeAt(start: Point, angle: 0 | 90): Place {
  return ([x, y]) => (angle === 0 ? [start[0] + x, start[1] + y] : [start[0] - y, start[1] + x]);
}

/** A ruler with its marks at the right side and its length at the end, as it is walked from `start`. */
function ruler(length: number, angle: 0 | 90, start: Point): SheetFrame {
  const place = placeAt(start, angle);
  const along = (from: Point, to: Point): Stroke => ({
    points: [place(from), place(to)],
    closed: false,
  });
  const strokes = [along([0, 0], [length, 0])];
  for (let at = 0; at <= length; ++at) strokes.push(along([at, 0], [at, -tickHeight(at)]));
  const end: Point = [length + 1, -capHeight * textSize];
  const text: TextLine = {
    // Without figures between: a number on a sheet is that of an edge.
    text: `${length} mm`,
    at: place(end),
    anchor: 'start',
    angle,
    size: textSize,
  };
  return { strokes, texts: [text] };
}

/** What a ruler's length takes behind it. */
const unitWidth = widthAtMost(`${rulerLength} mm`, textSize) + 1 + gap;

/** The longest ruler, in whole cm, that leaves so much room beside it; 0: none. */
function rulerFor(room: number): number {
  return Math.max(0, Math.min(rulerLength, 10 * Math.floor(room / 10)));
}

/** A box to measure, with its size in it. */
function scaleBox(left: number, bottom: number, width: number): SheetFrame {
  const [right, top] = [left + width, bottom + boxHeight];
  const isSquare = width === boxHeight;
  const size = isSquare ? smallSize : textSize;
  const text = isSquare ? `${width} mm` : `${width} × ${boxHeight} mm`;
  const at: Point = [left + width / 2, bottom + boxHeight / 2 - (capHeight / 2) * size];
  const points: Point[] = [
    [left, bottom],
    [right, bottom],
    [right, top],
    [left, top],
  ];
  return {
    strokes: [{ points, closed: true }],
    texts: [{ text, at, anchor: 'middle', angle: 0, size }],
  };
}

/** Of the arrow: half of its paper, and of its head. */
const [paperHalf, headHalf] = [1.8, 0.9];

function outsideWidth({ sheets: { outside } }: Words): number {
  return 2 * paperHalf + 1 + Math.max(...outside.map((line) => widthAtMost(line, textSize)));
}

/** The paper from the side, with an arrow that leaves it upwards, and what that means; in a band from `start`. */
function outsideMark(angle: 0 | 90, start: Point, { sheets }: Words): SheetFrame {
  const [upper, lower] = sheets.outside;
  const place = placeAt(start, angle);
  const [low, high] = [lowerLine, upperLine + capHeight * textSize];
  const open = (...points: Point[]): Stroke => ({ points: points.map(place), closed: false });
  const line = (text: string, y: number): TextLine => {
    const at = place([2 * paperHalf + 1, y]);
    return { text, at, anchor: 'start', angle, size: textSize };
  };
  const [head, foot] = [high - 1.2, paperHalf];
  return {
    strokes: [
      open([0, low], [2 * paperHalf, low]),
      open([foot, low], [foot, high]),
      open([foot - headHalf, head], [foot, high], [foot + headHalf, head]),
    ],
    texts: [line(upper, upperLine), line(lower, lowerLine)],
  };
}

/** What stands one after the other in the band below, and where the next thing begins. */
interface Row {
  parts: SheetFrame[];
  left: number;
}

/** Ruler and box: on small paper the ruler is shorter, and the box is in the corner. */
function measures({ margin, inset }: SheetFramePlan, room: number): Row {
  const { from, to } = bandOf(margin, inset);
  const across = rulerFor(room - unitWidth);
  const parts = across > 0 ? [ruler(across, 0, [to, from + bandHeight - lineRoom])] : [];
  const left = across > 0 ? to + across + unitWidth : to;
  if (left + boxWidth + gap <= to + room) {
    parts.push(scaleBox(left, from + (bandHeight - boxHeight) / 2, boxWidth));
    return { parts, left: left + boxWidth + gap };
  }
  // Where the bands meet there is nothing else.
  parts.push(scaleBox(from, from, boxHeight));
  return { parts, left };
}

/** The ruler at the left, and above it what has no room below. */
function leftBand(plan: SheetFramePlan, hasMark: boolean): SheetFrame[] {
  const { margin, height, ends, inset, words } = plan;
  const { from, to } = bandOf(margin, inset);
  const width = outsideWidth(words);
  const mark = hasMark ? width + gap : 0;
  const room = height - ends - margin - to;
  const up = rulerFor(room - unitWidth - mark);
  const top = up > 0 ? to + up + unitWidth : to;
  return [
    ...(up > 0 ? [ruler(up, 90, [from + lineRoom, to])] : []),
    ...(hasMark && width <= height - ends - margin - top
      ? [outsideMark(90, [from + bandHeight, top], words)]
      : []),
  ];
}

/** The frame of one sheet. On paper too small for all of it some parts are smaller or left out. */
export function frameSheet(plan: SheetFramePlan): SheetFrame {
  const { width, margin, title, note, ends, inset, words } = plan;
  const { from, to } = bandOf(margin, inset);
  const end = width - margin - ends;
  const noteWidth = widthAtMost(note, textSize);
  const { parts, left: first } = measures(plan, end - to - noteWidth);
  const behind = first + outsideWidth(words) + gap;
  const isBelow = behind + noteWidth <= end;
  if (isBelow) parts.push(outsideMark(0, [first, from], words));
  const left = isBelow ? behind : first;
  parts.push(...leftBand(plan, !isBelow));
  const line = (text: string, y: number): TextLine => ({
    text: shortened(text, textSize, end - left),
    at: [left, from + y],
    anchor: 'start',
    angle: 0,
    size: textSize,
  });
  const texts = [line(title, upperLine), line(note, lowerLine)].filter(({ text }) => text !== '');
  return {
    strokes: parts.flatMap(({ strokes }) => strokes),
    texts: [...parts.flatMap((part) => part.texts), ...texts],
  };
}
