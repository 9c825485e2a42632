import { flightTimes, foldEnd } from '../model/choreography.js';
import type { Piece } from '../model/job.js';
import { joinOrder } from '../model/join-order.js';
import type { Words } from '../words/words.js';

/** Letters of the pieces in the order in which they join. */
export function joiningLetters(pieces: readonly Piece[]): string[] {
  return joinOrder(pieces).map(({ piece }) => pieces[piece]!.name);
}

// Finer steps would change the words in nearly every frame, which costs as much as the picture.
const percentStep = 5;

/** Far less than between any two steps, and more than what adding up leaves. */
export const sameTime = 1e-9;

/** What there is to see at a time of the folding, from 0 to 1. */
export function folded({ folding }: Words, time: number, letters: readonly string[]): string {
  if (time <= 0) return folding.flat;
  if (time < foldEnd) {
    const percent = Math.round((100 * time) / foldEnd / percentStep) * percentStep;
    return folding.foldedBy(Math.min(Math.max(percent, percentStep), 100 - percentStep));
  }
  if (time >= 1) return folding.whole;
  const ends = letters.map((_, i) => flightTimes(i, letters.length).end);
  const placed = ends.findIndex((end) => Math.abs(time - end) < sameTime);
  if (placed >= 0 && letters.length > 1) return folding.inPlace(letters[placed]!);
  const rank = ends.findIndex((end) => time < end);
  return time > foldEnd && letters.length > 1 ? folding.joining(letters[rank]!) : folding.folded;
}

/** A warning where pieces are shown that may not fold like this; empty if all do. */
export function doubts({ folding }: Words, pieces: readonly Piece[]): string {
  const letters = pieces.filter(({ motion }) => !motion).map(({ name }) => name);
  if (letters.length === 0) return '';
  return folding.doubts(letters.length === pieces.length ? null : letters);
}
