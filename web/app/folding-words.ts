import { flightTimes, foldEnd } from '../model/choreography.js';
import type { Piece } from '../model/job.js';
import { joinOrder } from '../model/join-order.js';

/** Names as people list them: A; A and B; A, B and C. */
export function listed(names: readonly string[]): string {
  const last = names.at(-1) ?? '';
  return names.length < 2 ? last : `${names.slice(0, -1).join(', ')} and ${last}`;
}

/** Letters of the pieces in the order in which they join. */
export function joiningLetters(pieces: readonly Piece[]): string[] {
  return joinOrder(pieces).map(({ piece }) => pieces[piece]!.name);
}

// Finer steps would change the words in nearly every frame, which costs as much as the picture.
const percentStep = 5;

/** What there is to see at a time of the folding, from 0 to 1. */
export function folded(time: number, letters: readonly string[]): string {
  if (time <= 0) return 'flat';
  if (time < foldEnd) {
    const percent = Math.round((100 * time) / foldEnd / percentStep) * percentStep;
    return `folded by ${Math.min(Math.max(percent, percentStep), 100 - percentStep)} %`;
  }
  if (time >= 1) return 'the model';
  const rank = letters.findIndex((_, i) => time < flightTimes(i, letters.length).end);
  return time > foldEnd && letters.length > 1 ? `joining piece ${letters[rank]}` : 'folded';
}

/** A warning where pieces are shown that may not fold like this; empty if all do. */
export function doubts(pieces: readonly Piece[]): string {
  const letters = pieces.filter(({ motion }) => !motion).map(({ name }) => name);
  if (letters.length === 0) return '';
  const subject =
    letters.length === pieces.length
      ? 'No way to fold these pieces is'
      : `No way to fold ${listed(letters)} is`;
  return `${subject} known: all folds are shown turning evenly, and faces may pass through each other.`;
}
