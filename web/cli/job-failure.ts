import type { JobError } from '../core/job-error.js';
import { engineDied } from '../core/job-error.js';
import { Exit, exitStatus, usageError } from './exit.js';
import { modelError } from './read-model-file.js';

/** Codes with which the engine blames what was asked for and not the model. */
const optionCodes = ['bad-option', 'bad-margin', 'bad-edit'];

/** Codes of faults in the engine itself. */
const internalCodes = ['internal', engineDied];

/** How the program ends after a job that failed like this. */
export function exitOf(model: string, { code, message }: JobError): Exit {
  if (optionCodes.includes(code)) return usageError(message);
  if (internalCodes.includes(code)) return new Exit(exitStatus.internal, `foldwright: ${message}`);
  return modelError(model, message);
}
