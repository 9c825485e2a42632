import type { DocumentEdit } from '../model/document-edits.js';
import type { JobResult } from '../model/job.js';
import type { Project } from '../project/project.js';
import type { FinishedRun } from './finished-run.js';
import { sessionIn } from './replaced-model.js';
import type { OpenModel } from './store-needs.js';

/** A run that shall be there. */
export interface Presented {
  session: OpenModel;
  /** Whether it was not stopped before it had all nets. */
  isWhole?: boolean;
  /** Of the session. */
  position?: number;
  /** That have led to it. */
  edits?: readonly DocumentEdit[];
}

/** The run on the page, and its document, whose cursor is there unless something is being done. */
export class OnPage {
  private shown: FinishedRun | null = null;
  private open: OpenModel | null = null;
  private position = 0;
  /** What was shown last of each session, where a history has several. */
  private readonly runsOf = new WeakMap<OpenModel, FinishedRun>();

  /** Null until there is a result. */
  get run(): FinishedRun | null {
    return this.shown;
  }

  get session(): OpenModel | null {
    return this.open;
  }

  /** What undo would take back; null if there is nothing. */
  get undoable(): readonly DocumentEdit[] | null {
    return this.open?.lastStep ?? null;
  }

  /** The result that undo leads to, where it is at hand. */
  get before(): JobResult | null {
    return this.open?.before ?? null;
  }

  /** What redo would make again; null if there is nothing. */
  get redoable(): readonly DocumentEdit[] | null {
    return this.open?.nextStep ?? null;
  }

  /** The document as it can be kept; null until there is one. */
  get document(): Project | null {
    return this.open?.project() ?? null;
  }

  /** What was shown last of the model that is open in a session. */
  lastOf(session: OpenModel): FinishedRun | undefined {
    return this.runsOf.get(sessionIn(session));
  }

  /** Puts a run there, which is at this position of its session. */
  put(run: FinishedRun, session: OpenModel, position: number): void {
    this.runsOf.set(sessionIn(session), run);
    [this.shown, this.open, this.position] = [run, session, position];
  }

  /** The document goes back to what is shown; what cannot be shown can be made again. */
  comeBack(session: OpenModel): void {
    while (session.position > this.position && session.undo());
    while (session.position < this.position && session.redo());
  }
}
