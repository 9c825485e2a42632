/** What a person wants to know of a result before paper is spent on it; nothing where all is well. */
import type { JobResult, Notice } from './job.js';
import { sheetFills } from './paper-use.js';
import { shortSeams } from './short-seams.js';

/** Of a sheet that was worth printing, the share that is filled. */
const leastFill = 0.15;

/** Pieces that are smaller in both directions get lost; mm. */
const leastPiece = 10;

function emptySheet(result: JobResult, margin: number): Notice[] {
  const last = result.sheets.length - 1;
  const fill = sheetFills(result, margin)[last]!;
  if (last === 0 || fill >= leastFill) return [];
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
