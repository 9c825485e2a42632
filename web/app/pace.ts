/** Which change of a document need not wait for which. */
import type { Applied, Refusal } from '../api/edit-plan.js';
import type { RunWork } from '../api/work.js';
import type { DocumentEdit } from '../model/document-edits.js';
import type { OpenModel } from './store-needs.js';

/**
 * How a step goes with others. Names and the look of lines leave the numbers of parts alone (`light`), so
 * others need not wait for them; moves through the history name no parts, so they can follow each other.
 */
export type Pace = 'light' | 'move' | 'change';

/** A change that is not on the page yet. */
export interface Step {
  pace: Pace;
  edits: readonly DocumentEdit[];
  /** Makes it; false if there is nothing to do. */
  make(session: OpenModel, work: RunWork): Promise<Applied | Refusal | boolean>;
}

const followed: Readonly<Record<Pace, readonly Pace[]>> = {
  light: ['light'],
  move: ['light', 'move'],
  change: ['light'],
};

const lightKinds: readonly DocumentEdit['kind'][] = ['name', 'print'];

/** The pace of edits that are made in one go. */
export function paceOf(edits: readonly DocumentEdit[]): Pace {
  return edits.every(({ kind }) => lightKinds.includes(kind)) ? 'light' : 'change';
}

/** Whether a step may be asked for while another one is on its way to the page. */
export function mayFollow(next: Pace, before: Pace): boolean {
  return followed[next].includes(before);
}
