import { viewer as english, type ViewerFault } from '../../words/en/viewer.js';

/** Something that a viewer cannot do: the code is for programs, the message English. */
export class ViewerError extends Error {
  override readonly name = 'ViewerError';

  constructor(readonly code: ViewerFault) {
    super(english.faults[code]);
  }
}
