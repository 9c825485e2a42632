import type { Words } from './words.js';

/** How many models of a batch have come to what. */
export interface BatchCounts {
  all: number;
  /** Made now, and there already. */
  done: number;
  skipped: number;
  refused: number;
  failed: number;
  /** Not begun, or not ended. */
  left: number;
}

const outcomes = ['done', 'skipped', 'refused', 'failed', 'left'] as const;

/** What a batch has come to, in one line. */
export function batchSummary({ batch, speech }: Words, counts: BatchCounts): string {
  const told = outcomes
    .filter((outcome) => counts[outcome] > 0)
    .map((outcome) => batch.outcomes[outcome](counts[outcome]));
  return batch.about(batch.models(counts.all), speech.all(told));
}
