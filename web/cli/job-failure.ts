import type { JobError } from '../core/job-error.js';
import { blamesOptions, engineDied } from '../core/job-error.js';
import { Exit, exitStatus, usageError } from './exit.js';
import { modelError } from './read-model-files.js';

/** Codes of faults in the engine itself. */
const internalCodes = ['internal', engineDied];

/** How the program ends after a job that failed like this. */
export function exitOf(model: string, error: JobError): Exit {
  const { code, message } = error;
  if (blamesOptions(error)) return usageError(message);
  if (internalCodes.includes(code)) return new Exit(exitStatus.internal, `foldwright: ${message}`);
  return modelError(model, message);
}
