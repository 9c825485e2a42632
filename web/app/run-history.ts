import type { FinishedRun } from './finished-run.js';

/** Results of large models take tens of megabytes: so many are kept. */
const longest = 20;

/** A result and how it came to be. */
interface Entry {
  run: FinishedRun;
  /** Names the change that made it of the one before; null if there is none before. */
  words: string | null;
}

/** The result on the page, and those that it was made of by changes, to go back to. */
export class RunHistory {
  private entries: Entry[] = [];

  /** Null until there is a result. */
  get current(): FinishedRun | null {
    return this.entries.at(-1)?.run ?? null;
  }

  /** Names the change that can be taken back; null if none can. */
  get undo(): string | null {
    return this.entries.length > 1 ? this.entries.at(-1)!.words : null;
  }

  /** Another model, or other options: there is nothing to go back to. */
  begin(run: FinishedRun): void {
    this.entries = [{ run, words: null }];
  }

  /** A change of the result before. */
  add(run: FinishedRun, words: string): void {
    this.entries = [...this.entries, { run, words }].slice(-longest);
  }

  /** What the last change was made of; null if there is nothing to go back to. */
  get before(): FinishedRun | null {
    return this.entries.at(-2)?.run ?? null;
  }

  /** Goes back by one change, of which there must be one. */
  back(): void {
    this.entries.pop();
  }
}
