import type { JobError } from '../core/job-error.js';
import { blamesOptions, engineDied } from '../core/job-error.js';
import { phraseOf } from '../words/phrase.js';
import { Exit, exitStatus, usageError, type Told } from './exit.js';
import { modelError } from './read-model-files.js';

/** Codes of faults in the engine itself. */
const internalCodes = ['internal', engineDied];

/** How the program ends after a job that failed like this. */
export function exitOf(model: string, error: JobError): Exit {
  const told: Told = (words) => phraseOf(words, error);
  if (blamesOptions(error)) return usageError(told);
  if (!internalCodes.includes(error.code)) return modelError(model, told);
  return new Exit(exitStatus.internal, (words) => `foldwright: ${told(words)}`);
}
