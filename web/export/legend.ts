/** What lines and numbers mean: only what occurs on the sheets. */
import type { PrintOptions } from '../model/print-options.js';
import { bandOf } from '../model/sheet-room.js';
import { lostBorder } from './calibration.js';
import type { Words } from '../words/words.js';
import type { SheetFrame, Stroke } from './sheet-frame.js';
import { FreeSpace } from './free-space.js';
import type { Point } from './point.js';
import type { PieceDrawing, SheetDrawing } from './sheet-drawing.js';
import { capHeight, walkAround, widthAtMost, type TextLine } from './text-line.js';

/** A sample at (0, 0), if it is more than words, and what it means. */
interface Entry {
  sample: Stroke[];
  text: string;
}

// 6 points, as the title.
const size = 2.1;
const rowHeight = 3.6;
const sampleWidth = 9;
const gap = 1.5;
/** Between columns. */
const columnGap = 3.5;
/** From the pieces, so that no one cuts into it. */
const clearance = 2;

function lineSample(kind: 'cut' | 'mountain' | 'valley'): Stroke[] {
  const y = (capHeight * size) / 2;
  return [
    {
      points: [
        [0, y],
        [sampleWidth, y],
      ],
      closed: false,
      sample: kind,
    },
  ];
}

function flapSample(): Stroke[] {
  const walk: Point[] = [
    [1, 0],
    [2.2, 2],
    [sampleWidth - 2.2, 2],
    [sampleWidth - 1, 0],
  ];
  return [
    { points: walk, closed: true, sample: 'flap' },
    { points: walk, closed: false, sample: 'cut' },
    { points: [walk[0]!, walk[3]!], closed: false, sample: 'mountain' },
  ];
}

function entriesFor(
  pieces: readonly PieceDrawing[],
  foldTicks: boolean,
  told: Words['sheets']['legend'],
): Entry[] {
  const texts = pieces.flatMap((piece) => piece.texts.map(({ text }) => text));
  const some = (test: (piece: PieceDrawing) => boolean): boolean => pieces.some(test);
  const line = (kind: 'cut' | 'mountain' | 'valley', text: string): Entry => {
    return { sample: lineSample(kind), text };
  };
  const words = (text: string): Entry => ({ sample: [], text });
  const hasIds = texts.some((text) => /^\d+$/.test(text));
  const hasPairs = texts.some((text) => /^(?:[A-Z]+|.*:)\d+$/.test(text));
  return [
    line('cut', told.cut),
    ...(some(({ mountains }) => mountains.length > 0) ? [line('mountain', told.mountain)] : []),
    ...(some(({ valleys }) => valleys.length > 0) ? [line('valley', told.valley)] : []),
    ...(foldTicks && some(({ mountains, valleys }) => mountains.length + valleys.length > 0)
      ? [words(told.ticks)]
      : []),
    ...(some(({ flaps }) => flaps.length > 0) ? [{ sample: flapSample(), text: told.flap }] : []),
    ...(hasIds ? [words(told.number)] : []),
    ...(some((piece) => piece.texts.some(({ underlined }) => underlined))
      ? [words(told.underlined)]
      : []),
    ...(hasPairs ? [words(told.pair)] : []),
    ...(some(({ hasTape }) => hasTape) ? [words(told.tape)] : []),
    ...(some(({ letter }) => letter.startsWith('strip-')) ? [words(told.strip)] : []),
    ...(texts.some((text) => text.endsWith('°')) ? [words(told.angle)] : []),
  ];
}

function widthOf({ sample, text }: Entry): number {
  return (sample.length > 0 ? sampleWidth + gap : 0) + widthAtMost(text, size);
}

/** Entries in columns, filled one after the other, with (0, 0) at their lower left. */
function inColumns(
  entries: readonly Entry[],
  columns: number,
): { content: SheetFrame; width: number; height: number } {
  const rows = Math.ceil(entries.length / columns);
  const content: SheetFrame = { strokes: [], texts: [] };
  let left = 0;
  for (let first = 0; first < entries.length; first += rows) {
    const column = entries.slice(first, first + rows);
    column.forEach((entry, i) => {
      const bottom = (rows - 1 - i) * rowHeight;
      const moved = ([x, y]: Point): Point => [left + x, bottom + y];
      for (const stroke of entry.sample) {
        content.strokes.push({ ...stroke, points: stroke.points.map(moved) });
      }
      const start = entry.sample.length > 0 ? sampleWidth + gap : 0;
      const at = moved([start, 0]);
      content.texts.push({ text: entry.text, at, anchor: 'start', angle: 0, size });
    });
    left += Math.max(...column.map(widthOf)) + columnGap;
  }
  return { content, width: left - columnGap, height: (rows - 1) * rowHeight + size };
}

function movedBy({ strokes, texts }: SheetFrame, [x, y]: Point): SheetFrame {
  const move = ([u, v]: Point): Point => [u + x, v + y];
  return {
    strokes: strokes.map((stroke) => ({ ...stroke, points: stroke.points.map(move) })),
    texts: texts.map((text): TextLine => ({ ...text, at: move(text.at) })),
  };
}

function onFreeSpace(sheet: SheetDrawing, entries: Entry[], margin: number): SheetFrame | null {
  const { to } = bandOf(margin);
  // From the ruler below as from pieces.
  const area = {
    left: to,
    bottom: to + 1.5,
    right: sheet.width - margin,
    top: sheet.height - margin,
  };
  // Those at the left edge of the sheet lie outside the area.
  const upright = sheet.frame.texts.filter(({ angle }) => angle === 0);
  const space = new FreeSpace(
    area,
    [...sheet.pieces.flatMap(({ cuts }) => cuts), ...upright.map(walkAround)],
    clearance,
  );
  // High, low and broad.
  for (const columns of [1, 2, 3, entries.length]) {
    const { content, width, height } = inColumns(entries, columns);
    const place = space.place(width, height + 0.6);
    // Below the baseline there are descenders.
    if (place) return movedBy(content, [place[0], place[1] + 0.6]);
  }
  return null;
}

/** In one row above the pieces, where the margin is as high as the band below them. */
function inUpperMargin(
  { width, height }: SheetDrawing,
  entries: Entry[],
  margin: number,
  inset: number,
): SheetFrame | null {
  const { from, to } = bandOf(margin, inset);
  const row = inColumns(entries, entries.length);
  if (to > margin || row.width > width - 2 * margin) return null;
  return movedBy(row.content, [margin, height - from - size - 1]);
}

/**
 * Puts a legend on one of the sheets: on free space of the first, else into its upper margin if that
 * is wide enough, else on free space of another.
 *
 * @returns the number of the sheet and what is added to it; null if no sheet has room
 */
export function placeLegend(
  sheets: readonly SheetDrawing[],
  margin: number,
  options: Pick<PrintOptions, 'foldTicks' | 'machine' | 'measured'>,
  words: Words,
): { sheet: number; legend: SheetFrame } | null {
  const entries = entriesFor(
    sheets.flatMap(({ pieces }) => pieces),
    options.foldTicks,
    words.sheets.legend,
  );
  for (const [sheet, drawing] of sheets.entries()) {
    const legend =
      onFreeSpace(drawing, entries, margin) ??
      (sheet === 0 ? inUpperMargin(drawing, entries, margin, lostBorder(drawing, options)) : null);
    if (legend) return { sheet, legend };
  }
  return null;
}
