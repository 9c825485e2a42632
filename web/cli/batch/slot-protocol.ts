/** What the batch and the thread that does its models say to each other; types only. */
import type { WrittenFile } from '../../export/formats.js';
import type { BatchCommands } from './batch-line.js';
import type { ModelEvent } from './batch-events.js';
import type { ListedModel } from './list-models.js';
import type { ModelRecord } from './record.js';

/** With what a thread begins. */
export interface SlotData {
  commands: Pick<BatchCommands, 'formats' | 'given' | 'out' | 'settings'>;
  /** Engine workers of its own. */
  workers: number;
}

/** To a thread without a model. Answered by `event`s and at last an `outcome`. */
export type SlotOrder = ListedModel;

/** What became of a model; `current`: all is there already. The files do not hold the record itself. */
export interface SlotOutcome {
  isCurrent: boolean;
  record: ModelRecord;
  files: WrittenFile[];
  /** Since the order. */
  seconds: number;
}

export type SlotAnswer =
  { type: 'event'; event: ModelEvent } | { type: 'outcome'; outcome: SlotOutcome };
