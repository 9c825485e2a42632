import { english } from '../words/en/index.js';
import type { Words } from '../words/words.js';

/** Exit statuses; part of the command line's contract. */
export const exitStatus = {
  done: 0,
  internal: 1,
  usage: 2,
  model: 3,
  cancelled: 4,
} as const;

/** A sentence in the language of the run. */
export type Told = (words: Words) => string;

/** Whatever a file's name or an engine's message contains, it stays one line. */
function lineOf(told: Told | null, words: Words): string {
  return (told?.(words) ?? '').replace(/\s*[\r\n]+\s*/g, ' ');
}

/** Ends the program with a status and one line on stderr; none if there is nothing to tell. The message is English. */
export class Exit extends Error {
  /** @param reason what is wrong, without the name of what it is wrong with */
  constructor(
    readonly status: number,
    private readonly told: Told | null = null,
    private readonly reason: Told | null = told,
  ) {
    super(lineOf(told, english));
  }

  /** What it tells, in one line. */
  lineIn(words: Words): string {
    return lineOf(this.told, words);
  }

  /** The same without the name of what it is about. */
  reasonIn(words: Words): string {
    return lineOf(this.reason, words);
  }
}

/** The command line cannot be done as it stands. */
export function usageError(told: Told): Exit {
  return new Exit(exitStatus.usage, (words) => `foldwright: ${told(words)}`);
}
