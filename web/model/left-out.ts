/** What a result has no room for: names, flaps and numbers. */
import type { JobResult, Notice } from './job.js';
import { wantedSeams } from './seam-measures.js';

/** The seams without a flap, by why there is none, and the pieces that they are on. */
function missingFlaps(result: JobResult): Notice[] {
  const { missing, missing_mm, strips, wanted_mm } = result.flaps;
  const count = missing.narrow + missing.thin + missing.blocked + missing.short;
  if (count === 0) return [];
  const bare = wantedSeams(result).filter(({ flap }) => flap === 0);
  const isConcerned = new Set(bare.flatMap(({ seam }) => seam.pieces));
  const pieces = result.pieces.filter((_, i) => isConcerned.has(i)).map(({ name }) => name);
  const percent = Math.round((100 * missing_mm) / wanted_mm);
  return [{ code: 'missing-flaps', params: { count, ...missing, percent, strips, pieces } }];
}

/** The seams without a number at one side at least. */
function missingNumbers({ ids: { skipped } }: JobResult): Notice[] {
  if (skipped.length === 0) return [];
  return [{ code: 'missing-numbers', params: { seams: skipped } }];
}

/** The pieces that do not say which they are. */
export function namelessPieces({ pieces }: JobResult): string[] {
  return pieces
    .filter(({ name, labels }) => labels.every(({ text }) => text !== name))
    .map(({ name }) => name);
}

function missingNames(result: JobResult): Notice[] {
  const pieces = namelessPieces(result);
  return pieces.length > 0 ? [{ code: 'missing-names', params: { pieces } }] : [];
}

/** One notice for each kind of thing that is left out; none if nothing is. */
export function leftOut(result: JobResult): Notice[] {
  return [...missingNames(result), ...missingFlaps(result), ...missingNumbers(result)];
}
