/** What runs and steps come to, before any of it is on the page. */
import type { DocumentState } from '../api/document-state.js';
import type { RunWork } from '../api/work.js';
import { JobError } from '../core/job-error.js';
import type { TimedEvent } from '../core/protocol.js';
import { failureOf, type Ending } from './ending.js';
import type { FinishedRun } from './finished-run.js';
import type { NextRun } from './next-run.js';
import type { Step } from './pace.js';
import type { RunPictures } from './run-pictures.js';
import type { OpenModel } from './store-needs.js';
import type { WorkEnd } from './work-end.js';

/** What ends work, and who hears of it. */
export interface Watch {
  end: WorkEnd;
  onEvent: (event: TimedEvent) => void;
}

/** `isWhole`: it was not stopped before it had all nets. */
export interface MadeRun {
  session: OpenModel;
  run: FinishedRun;
  isWhole: boolean;
}

/** A document after a step, and the step's place in its history. */
export interface MadeStep {
  state: DocumentState;
  position: number;
}

/** How work ended that came to nothing. @param wasRead whether the model had been read by then */
function endingOf(error: unknown, end: WorkEnd, wasRead: boolean): Ending {
  if (end.left.aborted) return { type: 'cancelled' };
  if (end.stopped.aborted) return { type: 'empty' };
  if (!(error instanceof JobError)) throw error;
  return failureOf(error, wasRead);
}

/** Each run has a session of its own: that of the page stays until there is another run to show. */
export async function makeRun(
  next: NextRun,
  pictures: RunPictures,
  { end, onEvent }: Watch,
): Promise<Ending | MadeRun> {
  let [wasRead, isWhole] = [false, true];
  const work: RunWork = {
    signal: end.left,
    stop: end.stopped,
    onEvent(event) {
      wasRead ||= event.type === 'model';
      if (event.type === 'cancelled') isWhole = false;
      onEvent(event);
    },
    pictures: true,
    drafts: true,
  };
  try {
    const session = await next.make(work);
    return { session, run: await next.finished(session, pictures), isWhole };
  } catch (error) {
    return endingOf(error, end, wasRead);
  }
}

/** Makes a step of a document. */
export async function makeStep(
  session: OpenModel,
  step: Step,
  { end, onEvent }: Watch,
): Promise<Ending | MadeStep> {
  const work: RunWork = { signal: end.left, stop: end.stopped, onEvent };
  try {
    end.left.throwIfAborted();
    const made = await step.make(session, work);
    if (made === false) return { type: 'nothing' };
    if (made !== true && !made.ok) return { type: 'refused', refusal: made };
    const { position } = session;
    return { state: await session.state(work), position };
  } catch (error) {
    return endingOf(error, end, true);
  }
}
