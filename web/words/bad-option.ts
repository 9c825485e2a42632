import { english } from './en/index.js';
import type { OptionFault } from './messages.js';

/** An option that there is not, or a value that it does not take: `params` are for programs, the message for people. */
export class BadOption extends Error {
  override readonly name = 'BadOption';
  readonly code = 'bad-option';

  constructor(readonly params: OptionFault) {
    super(english.optionFault(params));
  }
}
