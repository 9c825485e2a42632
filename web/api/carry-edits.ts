/** Makes the edits of a document again in that of a corrected model. */
import type { DocumentEdit } from '../model/document-edits.js';
import type { JobResult } from '../model/job.js';
import type { Message } from '../model/message.js';
import { ModelMatch } from '../model/model-match.js';
import { movedEdit } from '../model/moved-edit.js';
import type { DocumentState } from './document-state.js';
import type { Session } from './session.js';
import type { WorkOptions } from './work.js';

/** What this needs of sessions. */
type Walked = Pick<Session, 'state' | 'undo' | 'redo' | 'position' | 'nextStep'>;
type Edited = Pick<Session, 'state' | 'apply'>;

/** An edit that was not made again. */
export interface LostEdit {
  edit: DocumentEdit;
  /** In which it was made. */
  before: JobResult;
  reason: Message;
}

/** What has become of the edits of a document. */
export interface CarriedEdits {
  /** How many were made again. */
  kept: number;
  lost: readonly LostEdit[];
}

function moveTo(session: Walked, position: number): void {
  while (session.position > position && session.undo());
  while (session.position < position && session.redo());
}

/** Tries the edits of a step, of which those that fit are made in one go, as they were. */
async function carryStep(
  edits: readonly DocumentEdit[],
  match: ModelMatch,
  { result: before }: DocumentState,
  to: Edited,
  work: WorkOptions,
): Promise<LostEdit[]> {
  const { result: after } = await to.state(work);
  const tried = edits.map((edit) => ({ edit, moved: movedEdit(edit, match, before, after) }));
  const lost: LostEdit[] = [];
  const fitting: { edit: DocumentEdit; moved: DocumentEdit }[] = [];
  for (const { edit, moved } of tried) {
    if ('kind' in moved) fitting.push({ edit, moved });
    else lost.push({ edit, before, reason: moved });
  }
  if (fitting.length === 0) return lost;
  const made = await to.apply(
    fitting.map(({ moved }) => moved),
    work,
  );
  if (!made.ok) lost.push(...fitting.map(({ edit }) => ({ edit, before, reason: made })));
  return lost;
}

/**
 * Makes the edits of one document, as far as they are not undone, in another one of a corrected model: each at the place where it
 * was, if there still is one, and if the nets there allow it. The first document is left as it is.
 *
 * Rejects as `apply` does, and with the signal's reason. Cost: that of all edits, and of the states before them.
 * @pre both have a result
 */
export async function carryEdits(
  from: Walked,
  to: Edited,
  work: WorkOptions = {},
): Promise<CarriedEdits> {
  const end = from.position;
  const lost: LostEdit[] = [];
  let count = 0;
  try {
    moveTo(from, 0);
    const [first, corrected] = [await from.state(work), await to.state(work)];
    const match = new ModelMatch(first.result, corrected.result);
    while (from.position < end) {
      const edits = from.nextStep!;
      lost.push(...(await carryStep(edits, match, await from.state(work), to, work)));
      count += edits.length;
      from.redo();
    }
  } finally {
    moveTo(from, end);
  }
  return { kept: count - lost.length, lost };
}
