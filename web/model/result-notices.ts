import { equalPiecesNotices } from './equal-pieces.js';
import type { JobResult, Notice } from './job.js';
import { leftOut } from './left-out.js';
import { printAdvice } from './print-advice.js';

/** Names of the pieces that an independent check found to overlap themselves. */
export function overlappingPieces({ pieces }: JobResult): string[] {
  return pieces.filter(({ overlaps }) => overlaps > 0).map(({ name }) => name);
}

function overlaps(result: JobResult): Notice[] {
  const pieces = overlappingPieces(result);
  return pieces.length > 0 ? [{ code: 'overlapping-pieces', params: { pieces } }] : [];
}

/** Codes of the notices that the rows of a verdict tell as well. */
const inVerdict: ReadonlySet<string> = new Set([
  'run-stopped',
  'overlapping-pieces',
  'short-seams',
  'missing-flaps',
  'missing-numbers',
  'missing-names',
  'tiny-pieces',
  'empty-sheet',
  'smaller-saves-sheets',
  'weak-necks',
  'no-motion',
  'unchecked-pieces',
]);

/** What remains to be told beside a verdict. */
export function otherNotices(notices: readonly Notice[]): Notice[] {
  return notices.filter(({ code }) => !inVerdict.has(code));
}

/**
 * All that a person should know about a result, repairs of the model aside: the engine's notices and those
 * of the drawing, what has no room, and what to think of before printing.
 *
 * @param margin around each sheet, mm
 * @param printed what came up when the sheets were drawn
 */
export function resultNotices(
  result: JobResult,
  margin: number,
  printed: readonly Notice[],
): Notice[] {
  return [
    ...overlaps(result),
    ...result.notices,
    ...printed,
    ...leftOut(result),
    ...equalPiecesNotices(result),
    ...printAdvice(result, margin),
  ];
}
