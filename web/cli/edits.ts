import { merging, splitting } from '../model/edits.js';
import type { PartEdit } from '../model/job.js';
import { BadValue, whole } from './values.js';

// Far more parts than anyone could glue; the engine knows how many there are.
const anyPart = whole(1, 10_000_000);

function partOf(text: string): number {
  return anyPart(text) - 1;
}

/** PART[:K], parts counted from 1 as in notes. */
export function split(text: string): PartEdit {
  const [part = '', into = '2', ...rest] = text.split(':');
  if (rest.length > 0) throw new BadValue('is not PART or PART:K');
  return splitting(partOf(part), anyPart(into));
}

/** A,B, parts counted from 1 as in notes. */
export function merge(text: string): PartEdit {
  const parts = text.split(',').map(partOf);
  if (parts.length < 2) throw new BadValue('is not A,B');
  return merging(parts);
}
