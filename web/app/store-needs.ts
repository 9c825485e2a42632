/** What the state of a studio needs of the world around it. */
import type { Session } from '../api/session.js';
import type { TimedEvent } from '../core/protocol.js';
import type { ModelFiles } from '../model/model-files.js';
import type { FinishedRun } from './finished-run.js';

/** What the store needs of a session. */
export type OpenModel = Pick<
  Session,
  | 'inspect'
  | 'runWith'
  | 'state'
  | 'apply'
  | 'undo'
  | 'redo'
  | 'position'
  | 'lastStep'
  | 'nextStep'
  | 'before'
  | 'project'
  | 'settings'
>;

/** A run that is drawn, but not on the page yet. */
export interface Drawing {
  /** Puts all of it on the page at once: no two panels may ever show different runs. */
  show(how: { isRenaming: boolean }): void;
  /** It is not needed any more. */
  drop(): void;
}

export interface StoreNeeds {
  open(files: ModelFiles): Promise<OpenModel>;
  /** Null if a later drawing was quicker; rejects if the sheets cannot be drawn. */
  draw(run: FinishedRun): Promise<Drawing | null>;
  /** Hears what goes on in the present work. */
  follow(event: TimedEvent): void;
  /** Hears all that jobs tell, also those that were ended. */
  onEvent(event: TimedEvent): void;
  /** Ends all work; whoever waits for it waits for ever. */
  life: AbortSignal;
}
