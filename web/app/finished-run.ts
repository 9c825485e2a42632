import type { TimedResult } from '../core/client.js';
import type { ModelFile } from './model-file.js';
import type { Wishes } from './options-form.js';
import type { Settings } from './pending-settings.js';
import type { RunPictures } from './run-pictures.js';

/**
 * A finished run: what was asked for, what came out, and what it showed on the way. Whatever the page
 * shows of a result comes from one of these.
 */
export interface FinishedRun {
  model: ModelFile;
  wishes: Wishes;
  /** The form as it was then. */
  settings: Settings;
  pictures: RunPictures;
  result: TimedResult;
}
