/** The states of a document in their order, and which one is current. */
import type { Report } from '../export/report.js';
import type { DocumentEdit } from '../model/document-edits.js';
import type { SavedState } from '../project/project.js';
import { bytesOf, type DocumentState } from './document-state.js';
import type { WorkOptions } from './work.js';

/** Bytes of results that are kept: some hundred states of a thousand faces. */
const mostBytes = 256 * 1024 * 1024;

/** `before`: null for the first state. Null if the edits cannot be made any more. */
export type Remake = (
  before: DocumentState | null,
  work: WorkOptions,
) => Promise<DocumentState | null>;

/** A state, and how it comes about. */
export interface HistoryStep {
  /** What made it of the step before. */
  edits: readonly DocumentEdit[];
  remake: Remake;
  /** Null while it is not in memory. */
  state: DocumentState | null;
  /** As projects keep it; null if only `remake` leads there. */
  saved: SavedState | null;
}

interface Step extends HistoryStep {
  /** Null until it is asked for, or its state leaves the memory. */
  report: Report | null;
  bytes: number;
}

export interface HistoryTools {
  reportOf(state: DocumentState): Report;
  /** Makes a state of what was kept of it; null if that cannot be done. */
  restore?(saved: SavedState, work: WorkOptions): Promise<DocumentState | null>;
  /** Hears how many of the last steps could not be made again and are gone. */
  refused?(count: number): void;
}

function withSize(step: HistoryStep): Step {
  if (!step.state) return { ...step, report: null, bytes: 0 };
  const { looks, ...rest } = step.state.result;
  // Pictures are the same ones in all states.
  return { ...step, report: null, bytes: bytesOf([rest, looks?.surface]) };
}

/**
 * A list of states, each made of the one before by edits, with a cursor. The states farthest from the
 * cursor are dropped when there is no room, and made again when they are needed.
 */
export class History {
  private readonly list: Step[];

  /** @param cursor of the current state in the list */
  constructor(
    steps: readonly HistoryStep[],
    private cursor: number,
    private readonly tools: HistoryTools,
  ) {
    this.list = steps.map(withSize);
  }

  /** Of the current state in the list. */
  get position(): number {
    return this.cursor;
  }

  get edits(): readonly (readonly DocumentEdit[])[] {
    return this.list.slice(1, this.cursor + 1).map(({ edits }) => edits);
  }

  /** All edits, those that were undone as well. */
  get steps(): readonly (readonly DocumentEdit[])[] {
    return this.list.slice(1).map(({ edits }) => edits);
  }

  /** All states as projects keep them. */
  get saved(): readonly (SavedState | null)[] {
    return this.list.map(({ saved }) => saved);
  }

  /** What redo would make again; null if there is nothing. */
  get next(): readonly DocumentEdit[] | null {
    return this.list[this.cursor + 1]?.edits ?? null;
  }

  /** The state that undo leads to; null if there is none, or it is not in memory. */
  get before(): DocumentState | null {
    return this.list[this.cursor - 1]?.state ?? null;
  }

  get canUndo(): boolean {
    return this.cursor > 0;
  }

  get canRedo(): boolean {
    return this.cursor + 1 < this.list.length;
  }

  /** Of the current state. @throws Error if that was never in memory */
  get report(): Report {
    const report = this.reportOf(this.list[this.cursor]!);
    if (!report) throw new Error('This state was not computed yet: call result first');
    return report;
  }

  /** Moves the cursor; false if there is no step there. */
  move(by: 1 | -1): boolean {
    if (this.list[this.cursor + by] === undefined) return false;
    this.cursor += by;
    return true;
  }

  /** Takes in a state that follows the current one; what was undone is gone. */
  add(step: HistoryStep): void {
    this.list.length = this.cursor + 1;
    this.list.push(withSize(step));
    this.cursor += 1;
    this.dropFar();
  }

  /** The current state; made again from the last one that can be had if need be. */
  async current(work: WorkOptions): Promise<DocumentState> {
    const wanted = this.cursor;
    let { at, state } = await this.lastKnown(wanted, work);
    for (; at < wanted; ++at) {
      const made = await this.list[at + 1]!.remake(state, work);
      if (!made) return this.endAt(at, work);
      state = made;
    }
    this.take(this.list[wanted]!, state!);
    return state!;
  }

  /** The last state up to a step that is in memory or can be restored; before the first one there is none. */
  private async lastKnown(
    wanted: number,
    work: WorkOptions,
  ): Promise<{ at: number; state: DocumentState | null }> {
    for (let at = wanted; at >= 0; --at) {
      const step = this.list[at]!;
      const { saved } = step;
      const state = step.state ?? (saved && (await this.tools.restore?.(saved, work)));
      if (state) return { at, state };
    }
    return { at: -1, state: null };
  }

  /** Goes on without the steps behind one, which cannot be made again. */
  private endAt(last: number, work: WorkOptions): Promise<DocumentState> {
    this.tools.refused?.(this.list.length - 1 - last);
    this.list.length = last + 1;
    this.cursor = last;
    return this.current(work);
  }

  private take(step: Step, state: DocumentState): void {
    if (!step.state) Object.assign(step, withSize({ ...step, state }));
    this.dropFar();
  }

  /** Made once, and only when it is needed: small edits would take a fifth longer. */
  private reportOf(step: Step): Report | null {
    if (step.state) step.report ??= this.tools.reportOf(step.state);
    return step.report;
  }

  private dropFar(): void {
    const kept = this.list
      .map((step, index) => ({ step, distance: Math.abs(index - this.cursor) }))
      .filter(({ step }) => step.state)
      .sort((a, b) => a.distance - b.distance);
    let bytes = 0;
    for (const { step, distance } of kept) {
      bytes += step.bytes;
      if (bytes <= mostBytes || distance === 0) continue;
      this.reportOf(step);
      step.state = null;
    }
  }
}
