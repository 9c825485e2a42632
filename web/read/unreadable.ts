import type { MessageParams } from '../model/message.js';
import type { Code, Messages } from '../words/messages.js';

/** Files that give no model; code and parameters say why, `web/words` has the sentence. */
export class Unreadable extends Error {
  constructor(
    readonly code: string,
    readonly params: MessageParams,
  ) {
    super(code);
  }
}

export function unreadable<Name extends Code>(
  code: Name,
  params: Messages[Name] & MessageParams,
): Unreadable {
  return new Unreadable(code, params);
}
