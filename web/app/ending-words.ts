/** How the studio tells what work has come to. */
import type { Ending, Failure } from './ending.js';
import type { FinishedRun } from './finished-run.js';
import { hopeless, leadSentence } from './result-words.js';

/** What a person can do about a failure. */
export const nextSteps: Readonly<Record<Failure['cause'], string>> = {
  file: 'Choose another model, or repair this one and try again.',
  job: 'Change the settings and try again, or choose another model.',
  crash: 'Nothing else is lost, and the next run starts afresh. A smaller model may work.',
};

/** What is said of the pictures of a run that has no result. */
export const notes: Readonly<Partial<Record<Ending['type'], string>>> = {
  cancelled: 'Cancelled. This is how far it came.',
  failed: 'This is how far it came.',
  undrawn: 'The nets were found, but not drawn.',
};

/** A result in one sentence; that nobody can build it, where that is so. */
export function leadOf({ result, settings: { margin, paper } }: FinishedRun): string {
  return hopeless(result, margin) ?? leadSentence(result, paper);
}
