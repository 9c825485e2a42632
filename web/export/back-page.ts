/** Backs of sheets that are printed on both sides, so that fold lines need not cross the picture. */
import type { Words } from '../words/words.js';
import { alignmentCrosses, crossRoom } from './alignment-cross.js';
import type { Point, Segment } from './point.js';
import { bandHeight, bandOf } from '../model/sheet-room.js';
import { bandLines } from './sheet-frame.js';
import type { PieceDrawing, SheetDrawing } from './sheet-drawing.js';
import { shortened, type TextLine } from './text-line.js';

export interface BackPlan {
  /** The front, with its folds as lines. */
  sheet: SheetDrawing;
  /** Counted from 1, and how many there are. */
  number: number;
  count: number;
  /** Of the sheet; mm. */
  margin: number;
  /** What the bands shall keep from the edge of the sheet; mm. */
  inset: number;
  title: string;
  words: Words;
}

type Turn = (point: Point) => Point;

/** Where a point of the front is seen on the back of a sheet that is turned along its long edge. */
function turnOf({ width, height }: SheetDrawing): Turn {
  return height >= width ? ([x, y]) => [width - x, y] : ([x, y]) => [x, height - y];
}

/** The folds alone, as they are seen from the back: there a mountain is a valley. */
function backOfPiece({ letter, mountains, valleys }: PieceDrawing, turn: Turn): PieceDrawing {
  const turned = (folds: readonly Segment[]): Segment[] =>
    folds.map(([from, to]) => [turn(from), turn(to)]);
  return {
    letter,
    cuts: [],
    mountains: turned(valleys),
    valleys: turned(mountains),
    guides: [],
    hasTape: false,
    flaps: [],
    ground: [],
    texts: [],
  };
}

/** What is said in the band that lies behind that below the pieces, between the crosses. */
function textsOf(plan: BackPlan): TextLine[] {
  const { sheet, number, count, margin, inset, title, words } = plan;
  const { width, height } = sheet;
  const { from, to } = bandOf(margin, inset);
  const bottom = height >= width ? from : height - from - bandHeight;
  const left = Math.max(to, margin + crossRoom);
  const { size } = bandLines;
  const line = (text: string, y: number): TextLine => {
    const at: Point = [left, bottom + y];
    return { text: shortened(text, size, width - 2 * left), at, anchor: 'start', angle: 0, size };
  };
  return [
    line(`${title} · ${words.sheets.back(number, count)}`, bandLines.upper),
    line(words.sheets.backHow, bandLines.lower),
  ].filter(({ text }) => text !== '');
}

/** The back of a sheet: mirrored once, about the axis along its long edge. */
export function backOf(plan: BackPlan): SheetDrawing {
  const { sheet, margin, inset } = plan;
  const { width, height, pieces } = sheet;
  const turn = turnOf(sheet);
  const strokes = alignmentCrosses(sheet, margin, inset).map((stroke) => ({
    ...stroke,
    points: stroke.points.map(turn),
  }));
  return {
    width,
    height,
    pieces: pieces.map((piece) => backOfPiece(piece, turn)),
    frame: { strokes, texts: textsOf(plan) },
  };
}

/** All pages in the order in which a printer takes them, each sheet with its back behind it. */
export function inPairs(
  pages: readonly SheetDrawing[],
  sheets: readonly SheetDrawing[],
  backs: readonly SheetDrawing[],
): SheetDrawing[] {
  if (backs.length === 0) return [...pages, ...sheets];
  // The first sheet must be a front.
  const blank = pages.length % 2 === 1 ? [blankLike(pages[0]!)] : [];
  return [...pages, ...blank, ...sheets.flatMap((sheet, i) => [sheet, backs[i]!])];
}

function blankLike({ width, height }: SheetDrawing): SheetDrawing {
  return { width, height, pieces: [], frame: { strokes: [], texts: [] } };
}
