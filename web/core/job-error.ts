import type { MessageParams } from '../model/message.js';
import { englishPhrase } from '../words/phrase.js';

/**
 * A job that failed: `code` and `params` are for programs, the message is one English phrase, `faces` are those
 * of the repaired model that it is about.
 */
export class JobError extends Error {
  override readonly name = 'JobError';

  constructor(
    readonly code: string,
    readonly params: MessageParams = {},
    readonly faces?: Int32Array,
  ) {
    super(englishPhrase({ code, params }));
  }
}

/** The code of a job whose worker died under it. */
export const engineDied = 'engine-died';

/** Codes with which the engine blames what was asked for and not the model. */
const optionCodes = ['bad-option', 'bad-margin', 'bad-edit'];

/** Whether a job failed for its options or edits. */
export function blamesOptions({ code }: JobError): boolean {
  return optionCodes.includes(code);
}
