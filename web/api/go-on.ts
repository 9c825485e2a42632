/** Goes on with an opened project under other options. */
import { paperOptions, printOptionNames, changedSettings } from './written-options.js';
import type { Refusal } from './edit-plan.js';
import type { Session } from './session.js';
import type { WorkOptions } from './work.js';

type Given = Readonly<Record<string, unknown>>;

function subset(given: Given, names: ReadonlySet<string>): Given {
  return Object.fromEntries(Object.entries(given).filter(([name]) => names.has(name)));
}

/** An edit that is not possible any more, counted from 0 among the calls that made the document. */
export interface BlockedEdit {
  refusal: Refusal;
  step: number;
}

/** The run once more, with its edits behind it. */
async function runAgain(
  session: Session,
  given: Given,
  work: WorkOptions,
): Promise<BlockedEdit | null> {
  const steps = session.steps.slice(0, session.position);
  await session.runWith(changedSettings(session.settings!, given), work);
  for (const [step, edits] of steps.entries()) {
    const made = await session.apply(edits, work);
    if (!made.ok) return { refusal: made, step };
  }
  return null;
}

/**
 * Computes the result of an opened project, with some options in the place of its own. Those of sheets and lines become
 * edits; all others take another run, and the edits are made again after it.
 *
 * @param given by the names of the command line
 * @returns what stands in the way; null if nothing does
 * @pre the session has a document
 */
export async function goOn(
  session: Session,
  given: Given,
  work: WorkOptions = {},
): Promise<BlockedEdit | null> {
  const paper = subset(given, paperOptions);
  const print = subset(given, printOptionNames);
  const changes = [
    { kind: 'paper', options: paper },
    { kind: 'print', options: print },
  ] as const;
  const all = changes.map(({ options }) => Object.keys(options).length);
  if (Object.keys(given).length > all[0]! + all[1]!) return runAgain(session, given, work);
  for (const [i, edit] of changes.entries()) {
    if (all[i] === 0) continue;
    const made = await session.apply(edit, work);
    if (!made.ok) return { refusal: made, step: session.position };
  }
  await session.result(work);
  return null;
}
