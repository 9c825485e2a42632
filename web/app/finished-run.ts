import type { DocumentState } from '../api/document-state.js';
import type { TimedResult } from '../core/client.js';
import type { EdgeLock, PinnedPiece } from '../model/job-options.js';
import type { Settings } from '../model/options.js';
import type { ChosenModel } from './model-file.js';
import type { FieldValues } from './pending-settings.js';
import type { RunPictures } from './run-pictures.js';

/**
 * A finished run: what was asked for, what came out, and what it showed on the way. Whatever the page
 * shows of a result comes from one of these.
 */
export interface FinishedRun {
  model: ChosenModel;
  settings: Settings;
  /** The form as it was then. */
  fields: FieldValues;
  pictures: RunPictures;
  /** Edges that are always folds, or always cut. */
  locks: readonly EdgeLock[];
  result: TimedResult;
  /** Pieces that stay where a person put them. */
  pins: readonly PinnedPiece[];
}

/** A run that has just come to its result, without any edits. */
export function newRun(made: Omit<FinishedRun, 'locks' | 'pins'>): FinishedRun {
  return { ...made, locks: [], pins: [] };
}

/** The same run after edits that have led its document to another state. */
export function editedRun(run: FinishedRun, { wishes, result }: DocumentState): FinishedRun {
  const { settings, locks, pins } = wishes;
  return { ...run, settings, locks, pins, result };
}
