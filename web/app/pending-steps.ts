import { renamedBy } from '../model/edits.js';
import type { DocumentEdit } from '../model/document-edits.js';
import type { PartName } from '../model/job-options.js';
import { mayFollow, type Pace, type Step } from './pace.js';

/** The changes of a document that are not on the page yet, in the order in which they were asked for. */
export class PendingSteps {
  private steps: readonly Step[] = [];
  private last: Promise<unknown> = Promise.resolve();

  get isEmpty(): boolean {
    return this.steps.length === 0;
  }

  /** Whether one of them may change the numbers of parts. */
  get areHeavy(): boolean {
    return this.steps.some(({ pace }) => pace !== 'light');
  }

  /** Whether another one may be asked for. */
  accept(pace: Pace): boolean {
    return this.steps.every((step) => mayFollow(pace, step.pace));
  }

  /** Names of parts as they will be; which ones a move leads to is not known before. */
  named(names: readonly PartName[]): readonly PartName[] {
    const isMoving = this.steps.some(({ pace }) => pace === 'move');
    const edits: readonly DocumentEdit[] = isMoving ? [] : this.steps.flatMap((step) => step.edits);
    return renamedBy(edits, names);
  }

  add(step: Step): void {
    this.steps = [...this.steps, step];
  }

  remove(step: Step): void {
    this.steps = this.steps.filter((other) => other !== step);
  }

  /** Does work after that of the step before, whatever came of it; the next one can be made while this one is drawn. */
  inTurn<Value>(work: () => Promise<Value>): Promise<Value> {
    const done = this.last.then(work);
    this.last = done.catch(() => undefined);
    return done;
  }
}
