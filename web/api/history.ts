/** The states of a document in their order, and which one is current. */
import type { Report } from '../export/report.js';
import type { DocumentEdit } from '../model/document-edits.js';
import { bytesOf, type DocumentState } from './document-state.js';
import type { WorkOptions } from './work.js';

/** Bytes of results that are kept: some hundred states of a thousand faces. */
const mostBytes = 256 * 1024 * 1024;

/** `before`: null for the first state. */
type Remake = (before: DocumentState | null, work: WorkOptions) => Promise<DocumentState>;

interface Step {
  /** What made it of the step before. */
  edits: readonly DocumentEdit[];
  remake: Remake;
  report: Report;
  /** Null when its memory was needed. */
  state: DocumentState | null;
  bytes: number;
}

/**
 * A list of states, each made of the one before by edits, with a cursor. The states farthest from the
 * cursor are dropped when there is no room, and made again when they are needed.
 */
export class History {
  private readonly steps: Step[];
  private cursor = 0;

  constructor(
    first: DocumentState,
    remake: Remake,
    private readonly reportOf: (state: DocumentState) => Report,
  ) {
    this.steps = [this.step([], first, remake)];
  }

  /** Of the current state in the list. */
  get position(): number {
    return this.cursor;
  }

  get edits(): readonly (readonly DocumentEdit[])[] {
    return this.steps.slice(1, this.cursor + 1).map(({ edits }) => edits);
  }

  /** What redo would make again; null if there is nothing. */
  get next(): readonly DocumentEdit[] | null {
    return this.steps[this.cursor + 1]?.edits ?? null;
  }

  /** The state that undo leads to; null if there is none, or it was dropped. */
  get before(): DocumentState | null {
    return this.steps[this.cursor - 1]?.state ?? null;
  }

  get canUndo(): boolean {
    return this.cursor > 0;
  }

  get canRedo(): boolean {
    return this.cursor + 1 < this.steps.length;
  }

  /** Of the current state. */
  get report(): Report {
    return this.steps[this.cursor]!.report;
  }

  /** Moves the cursor; false if there is no step there. */
  move(by: 1 | -1): boolean {
    if (this.steps[this.cursor + by] === undefined) return false;
    this.cursor += by;
    return true;
  }

  /** Takes in a state that follows the current one; what was undone is gone. */
  add(edits: readonly DocumentEdit[], state: DocumentState, remake: Remake): void {
    this.steps.length = this.cursor + 1;
    this.steps.push(this.step(edits, state, remake));
    this.cursor += 1;
    this.dropFar();
  }

  /** The current state; made again from the last one that is kept if need be. */
  async current(work: WorkOptions): Promise<DocumentState> {
    const wanted = this.cursor;
    let from = wanted;
    while (from > 0 && !this.steps[from]!.state) --from;
    let state: DocumentState | null = null;
    for (const step of this.steps.slice(from, wanted + 1)) {
      state = step.state ?? (await step.remake(state, work));
    }
    this.steps[wanted]!.state = state;
    this.dropFar();
    return state!;
  }

  private step(edits: readonly DocumentEdit[], state: DocumentState, remake: Remake): Step {
    const { looks, ...rest } = state.result;
    // Pictures are the same ones in all states.
    const bytes = bytesOf([rest, looks?.surface]);
    return { edits, remake, state, report: this.reportOf(state), bytes };
  }

  private dropFar(): void {
    const kept = this.steps
      .map((step, index) => ({ step, distance: Math.abs(index - this.cursor) }))
      .filter(({ step }) => step.state)
      .sort((a, b) => a.distance - b.distance);
    let bytes = 0;
    for (const { step, distance } of kept) {
      bytes += step.bytes;
      if (bytes > mostBytes && distance > 0) step.state = null;
    }
  }
}
