import type { AssemblyStep } from '../model/assembly-steps.js';
import type { Piece } from '../model/job.js';
import { listed } from './folding-words.js';

function count(number: number, noun: string): string {
  return `${number} ${noun}${number === 1 ? '' : 's'}`;
}

function creasing({ folds, crease, turn }: AssemblyStep): string {
  if (folds === 0) return 'it has no folds';
  const other = crease === 'mountain' ? 'valley' : 'mountain';
  if (turn.length === 0) {
    return folds === 1
      ? `crease its only fold as a ${crease}`
      : `crease its ${folds} folds as ${crease}s`;
  }
  const turned =
    turn.length === 1 ? `this one into a ${other}` : `these ${turn.length} into ${other}s`;
  return `crease its ${folds} folds as ${crease}s, then turn ${turned}`;
}

/** A step in sentences; what `these` and the numbers are is shown on the sheets. */
export function stepWords(step: AssemblyStep, pieces: readonly Piece[]): string {
  const { seams, partners, borders } = step;
  const sentences = [`${creasing(step)}.`];
  if (seams.length === 1) sentences.push('Close its seam.');
  if (seams.length > 1)
    sentences.push(`Close its ${seams.length} seams in the order of their numbers.`);
  if (borders.length > 0) {
    const letters = partners.map((piece) => pieces[piece]!.name);
    sentences.push(`Glue it to ${listed(letters)} along ${count(borders.length, 'edge')}.`);
  }
  return sentences.join(' ');
}
