import { editsFault, type DocumentEdit, type EditFault } from '../model/document-edits.js';
import { english } from '../words/en/index.js';

/** A list of edits that is none: `params` are for programs, the message is for people and names the edit. */
export class BadEdit extends Error {
  override readonly name = 'BadEdit';
  readonly code = 'bad-edit';

  constructor(readonly params: EditFault) {
    super(english.editsFault(params));
  }
}

/**
 * Edits as they come from a file or another program.
 * @throws BadEdit that names the first one that is none, counted from 1
 */
export function readEdits(value: unknown): DocumentEdit[] {
  const fault = editsFault(value);
  if (fault !== null) throw new BadEdit(fault);
  return value as DocumentEdit[];
}
