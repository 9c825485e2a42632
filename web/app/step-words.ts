import type { AssemblyStep } from '../model/assembly-steps.js';
import type { Piece } from '../model/job.js';
import type { Words } from '../words/words.js';

/** A step in sentences; what `these` and the numbers are is shown on the sheets. */
export function stepWords(
  { steps }: Words,
  { borders, crease, folds, partners, seams, turn }: AssemblyStep,
  pieces: readonly Piece[],
): string {
  const letters = partners.map((piece) => pieces[piece]!.name);
  return [
    steps.crease({ folds, crease, turn: turn.length }),
    ...(seams.length > 0 ? [steps.close(seams.length)] : []),
    ...(borders.length > 0 ? [steps.glue(letters, borders.length)] : []),
  ].join(' ');
}
