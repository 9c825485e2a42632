import type { TimedResult } from '../core/client.js';
import type { EdgeLock } from '../model/job-options.js';
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
}
