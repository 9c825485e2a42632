import type { Words } from '../words/words.js';

/** Where a studio is on a page. Several may share one: each knows its own place and nothing else of the page. */
export interface StudioPlace {
  /** In the language of the studio. */
  readonly words: Words;
  /** Holds the studio's markup. */
  readonly root: ParentNode;
  /** Hears the keys that are pressed and the files that are dropped for this studio. */
  readonly ground: EventTarget;
  /** Aborted when the studio leaves the page: workers, listeners and timers end with it. */
  readonly life: AbortSignal;
}

/** For what shall go no further once its studio has left the page. */
export function never(): Promise<never> {
  return new Promise(() => undefined);
}
