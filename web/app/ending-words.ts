/** How the studio tells what work has come to. */
import type { Words } from '../words/words.js';
import type { FinishedRun } from './finished-run.js';
import { hopeless, leadSentence } from './result-words.js';

/** A result in one sentence; that nobody can build it, where that is so. */
export function leadOf(words: Words, { result, settings: { margin, paper } }: FinishedRun): string {
  return hopeless(words, result, margin) ?? leadSentence(words, result, paper);
}

/** The words of a kind of ending; empty if there are none. */
export function wordsFor(table: Readonly<Record<string, string>>, type: string): string {
  return table[type] ?? '';
}
