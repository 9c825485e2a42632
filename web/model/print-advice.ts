/** What a person wants to know of a result before paper is spent on it; nothing where all is well. */
import type { JobResult, Notice } from './job.js';
import { sheetFills } from './paper-use.js';
import { shortSeams } from './short-seams.js';

/** Of a sheet that was worth printing, the share that is filled. */
const leastFill = 0.15;

/** Pieces that are smaller in both directions get lost; mm. */
const leastPiece = 10;

/** How much of the last sheet is used, from 0 to 1; `margin`: around each sheet, mm. */
export function lastSheetFill(result: JobResult, margin: number): number {
  return sheetFills(result, margin).at(-1)!;
}

/** Whether the last of several sheets is almost empty; `margin`: around each sheet, mm. */
export function isSheetSpare(result: JobResult, margin: number): boolean {
  return result.sheets.length > 1 && lastSheetFill(result, margin) < leastFill;
}

/** A size a little below this one, at which fewer sheets do. */
export interface Smaller {
  what: 'height' | 'width' | 'depth';
  size_mm: number;
  sheets: number;
}

/** The engine's notice of such a size; null if there is none. */
export function smallerNotice({ notices }: JobResult): Smaller | null {
  const notice = notices.find(({ code }) => code === 'smaller-saves-sheets');
  return notice ? (notice.params as unknown as Smaller) : null;
}

function emptySheet(result: JobResult, margin: number): Notice[] {
  if (!isSheetSpare(result, margin)) return [];
  const last = result.sheets.length - 1;
  const fill = lastSheetFill(result, margin);
  const pieces = result.pieces.filter(({ sheet }) => sheet === last).map(({ name }) => name);
  return [
    { code: 'empty-sheet', params: { sheet: last + 1, percent: Math.round(100 * fill), pieces } },
  ];
}

/** Names of the pieces that are small in both directions, flaps included. */
export function tinyPieces({ pieces }: JobResult): string[] {
  return pieces
    .filter(({ width, height }) => width < leastPiece && height < leastPiece)
    .map(({ name }) => name);
}

function smallPieces(result: JobResult): Notice[] {
  const pieces = tinyPieces(result);
  return pieces.length > 0 ? [{ code: 'tiny-pieces', params: { pieces } }] : [];
}

/**
 * At most one notice of each kind: seams that are too short at this size, with the size and the number
 * of faces at which they are not; a last sheet that is almost empty; pieces that get lost.
 *
 * @param margin around each sheet, mm
 */
export function printAdvice(result: JobResult, margin: number): Notice[] {
  return [...shortSeams(result, margin), ...emptySheet(result, margin), ...smallPieces(result)];
}
