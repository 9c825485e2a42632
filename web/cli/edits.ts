import { readFileSync } from 'node:fs';
import { BadEdit, readEdits } from '../api/read-edits.js';
import type { DocumentEdit } from '../model/document-edits.js';
import { BadValue, whole } from '../model/option-values.js';
import { usageError } from './exit.js';

// Far more parts than anyone could glue; the engine knows how many there are.
const anyPart = whole(1, 10_000_000);

/** PART[:K] */
export function split(text: string): DocumentEdit {
  const [part = '', into = '2', ...rest] = text.split(':');
  if (rest.length > 0) throw new BadValue({ expected: 'words', words: ['PART', 'PART:K'] });
  return { kind: 'split', part: anyPart(part), into: anyPart(into) };
}

/** A,B */
export function merge(text: string): DocumentEdit {
  const parts = text.split(',').map(anyPart);
  if (parts.length < 2) throw new BadValue({ expected: 'words', words: ['A,B'] });
  return { kind: 'merge', parts };
}

/** PART=TEXT; what a text may be, the engine knows. */
export function partName(text: string): Extract<DocumentEdit, { kind: 'name' }> {
  const [, part, name] = /^([^=]*)=(.+)$/s.exec(text) ?? [];
  if (part === undefined || name === undefined)
    throw new BadValue({ expected: 'words', words: ['PART=TEXT'] });
  try {
    return { kind: 'name', part: anyPart(part), text: name };
  } catch (error) {
    if (!(error instanceof BadValue)) throw error;
    throw new BadValue({ ...error.fault, part });
  }
}

/**
 * A file with a list of edits, as JSON.
 * @throws Exit if it cannot be read, or holds anything else
 */
export function readEditsFile(path: string): DocumentEdit[] {
  try {
    return readEdits(JSON.parse(readFileSync(path, 'utf8')));
  } catch (error) {
    if (error instanceof BadEdit) {
      const { params } = error;
      throw usageError(({ command, editsFault }) => command.aboutFile(path, editsFault(params)));
    }
    const isText = error instanceof SyntaxError;
    throw usageError(({ command }) => (isText ? command.noJson(path) : command.unreadable(path)));
  }
}
