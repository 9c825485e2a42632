/** How the work that a person asked for can end. */
import type { Refusal } from '../api/edit-plan.js';
import type { Message } from '../model/message.js';
import { blamesOptions, engineDied, type JobError } from '../core/job-error.js';
import { tooManyFaces, type Check } from './check.js';
import type { FinishedRun } from './finished-run.js';

/** `cause`: the file holds no model that can be read, or the model or the settings are at fault, or the engine is. */
export interface Failure extends Message {
  type: 'failed';
  cause: 'file' | 'job' | 'crash';
}

export type Ending =
  /** The run is on the page; `isWhole`: it was not stopped before it had all nets. */
  | { type: 'shown'; run: FinishedRun; isWhole: boolean }
  /** Ended by the person; all is as it was. */
  | { type: 'cancelled' }
  /** Stopped by the person for its nets, but none was left; all is as it was. */
  | { type: 'empty' }
  /** A model was looked at and is ready to be unfolded. */
  | { type: 'inspected'; check: Check }
  | Failure
  /** An edit that cannot be made. */
  | { type: 'refused'; refusal: Refusal }
  /** The nets are there, but their sheets could not be drawn; all is as it was. */
  | { type: 'undrawn'; run: FinishedRun }
  /** There was nothing to do, or later work has taken over and ends otherwise. */
  | { type: 'nothing' };

/** @param wasRead whether the model had been read by then */
export function failureOf(error: JobError, wasRead: boolean): Failure {
  const { code, params } = error;
  if (code === engineDied) return { type: 'failed', code, params, cause: 'crash' };
  const isForSettings = blamesOptions(error) || code === tooManyFaces;
  return { type: 'failed', code, params, cause: wasRead || isForSettings ? 'job' : 'file' };
}
