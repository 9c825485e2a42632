import { version } from '../../package.json';
import type { TimedResult } from '../core/client.js';
import { JobError, engineDied } from '../core/job-error.js';
import type { Pool } from '../core/pool.js';
import { writeFiles } from '../export/files.js';
import type { FontLoader } from '../export/font-loader.js';
import type { RendererLoader } from '../export/renderer-loader.js';
import type { ExportFormat, WrittenFile } from '../export/formats.js';
import type { Print } from '../export/print.js';
import type { Report } from '../export/report.js';
import type { Settings } from '../model/options.js';
import type { DocumentEdit } from '../model/document-edits.js';
import { netKey, startAgain, startFrom } from '../model/edits.js';
import type { JobResult, JobStart } from '../model/job.js';
import type { JobOptions } from '../model/job-options.js';
import { probableModel, titleOf, type ModelFiles } from '../model/model-files.js';
import { projectEnding, type Project, type ReadProject } from '../project/project.js';
import { changedSettings, defaultSettings, type Options } from './written-options.js';
import { freshWishes, jobOf, printOf, type DocumentState } from './document-state.js';
import {
  planEdits,
  refusal,
  refusalOf,
  settledWishes,
  type Applied,
  type EditPlan,
  type Refusal,
} from './edit-plan.js';
import { beginningOf } from './file-nets.js';
import { History, type Remake } from './history.js';
import { stopped, withLasting } from './lasting-notices.js';
import { inspectModel, type Inspection } from './inspect.js';
import { LitResults } from './lit-results.js';
import { OpenedModel } from './opened-model.js';
import { OpenedProject } from './opened-project.js';
import { readEdits } from './read-edits.js';
import { outcome, together } from './run-outcome.js';
import { savedState, savedSettings } from './saved-state.js';
import { stateReport } from './state-report.js';
import type { RunWork, WorkOptions } from './work.js';

/** What a session needs of where it runs. */
export interface Surroundings {
  /** Gives the workers; is not asked before there is work for them. */
  pool: () => Pool;
  loadFont: FontLoader;
  loadRenderer: RendererLoader;
  /** Ends what was started for the session alone. */
  close?: () => void;
}

/** Codes with which the engine says that the fault is its own. */
const crashes: readonly string[] = [engineDied, 'internal', 'out-of-memory'];

const nothing = 'Nothing was unfolded yet: call run first';

/** Identifies the net of each piece. */
function netKeys({ nets, pieces }: TimedResult): string[] {
  return nets.slice(0, pieces.length).map(netKey);
}

/**
 * A model that is open: it can be unfolded, edited, and written. The files, the options of `run` and
 * the list of edits are the document; everything else is computed from them, so that the same document
 * gives the same bits. Calls are worked off one after the other. What an edit does not touch stays as it
 * is, on paper too. Results of earlier states are kept within 256 MiB, and computed again beyond.
 */
export class Session {
  private history: History | null = null;
  /** Of the model, once it was read. */
  private fileName: string | null = null;
  private lastWork: Promise<unknown> = Promise.resolve();
  private readonly model: OpenedModel;
  private readonly lit: LitResults;
  /** As the run was asked for. */
  private asked: Settings | null = null;

  /** @param read the project that is opened: its document is there at once, its result when it is first asked for */
  constructor(
    private readonly files: ModelFiles,
    private readonly surroundings: Surroundings,
    read?: ReadProject,
  ) {
    this.model = new OpenedModel(files, surroundings.pool);
    this.lit = new LitResults(this.model);
    if (read) this.reopen(new OpenedProject(this.model, read));
  }

  /** The options of the run; null before the first one. @internal */
  get settings(): Settings | null {
    return this.asked;
  }

  /** All calls of `apply` that were made, those that were undone as well. @internal */
  get steps(): readonly (readonly DocumentEdit[])[] {
    return this.history?.steps ?? [];
  }

  /** Edits that were made and not undone, the first one first. */
  get edits(): readonly DocumentEdit[] {
    return this.history?.edits.flat() ?? [];
  }

  /** Whether there is an edit to undo. */
  get canUndo(): boolean {
    return this.history?.canUndo ?? false;
  }

  /** Whether there is an edit to do again. */
  get canRedo(): boolean {
    return this.history?.canRedo ?? false;
  }

  /** Steps that were made and not undone; a step is what one call of `apply` has made. */
  get position(): number {
    return this.history?.position ?? 0;
  }

  /** The edits that undo would take back; null if there are none. */
  get lastStep(): readonly DocumentEdit[] | null {
    return this.history?.edits.at(-1) ?? null;
  }

  /** The result that undo leads to; null if there is none, or its memory was needed. @internal */
  get before(): JobResult | null {
    const before = this.history?.before;
    return before ? this.lit.asShown(before.result) : null;
  }

  /** The edits that redo would make again; null if there are none. */
  get nextStep(): readonly DocumentEdit[] | null {
    return this.history?.next ?? null;
  }

  /**
   * What came out, as the command line reports it in English.
   * @throws Error before the first run, and in an opened project before `result`
   */
  get report(): Report {
    if (!this.history) throw new Error(nothing);
    return this.history.report;
  }

  /**
   * Looks at the model and unfolds nothing: reads and repairs it, simplifies it to `faces` if they are given, and
   * leaves the document as it is. What was read stays for the runs that follow.
   *
   * Rejects as `run` does. Cost: about a second for 70,000 faces, mostly for reading and repairing.
   */
  inspect(
    options: Pick<Options, 'faces' | 'up' | 'repair' | 'fillHoles' | 'inside' | 'crossing'> = {},
    { signal }: Pick<WorkOptions, 'signal'> = {},
  ): Promise<Inspection> {
    return this.inTurn(async () => {
      const wishes = freshWishes(changedSettings(defaultSettings(), options));
      return inspectModel(this.model, jobOf(wishes), signal);
    });
  }

  /**
   * Unfolds the model; earlier edits are gone.
   *
   * Rejects with a `BadOption` for an option that there is not or a value out of its range, and with a
   * `JobError` for a model that cannot be read or used; the state before stays then.
   */
  run(options: Options = {}, work: RunWork = {}): Promise<Report> {
    return this.inTurn(() => this.begin(changedSettings(defaultSettings(), options), work));
  }

  /** The same with all options, which the engine checks. @internal */
  runWith(settings: Settings, work: RunWork = {}): Promise<Report> {
    return this.inTurn(() => this.begin(settings, work));
  }

  /**
   * Makes an edit, or several at once that split, merge and search whole parts: their numbers are those
   * of before. An edit that cannot be made changes nothing and says why.
   *
   * Rejects with a `BadEdit` for a value that is no edit.
   */
  apply(
    edit: DocumentEdit | readonly DocumentEdit[],
    work: RunWork = {},
  ): Promise<Applied | Refusal> {
    return this.inTurn(async () => {
      const edits = readEdits(Array.isArray(edit) ? edit : [edit]);
      if (!this.history) throw new Error(nothing);
      const before = await this.history.current(work);
      const plan = planEdits(before, edits);
      if (!plan.ok) return plan;
      const { position } = this.history;
      const state = await this.make(before, plan, work);
      if ('ok' in state) return state;
      if (this.history.position !== position) {
        return refusal('overtaken', {});
      }
      // What an ended edit has found depends on when it was ended: it cannot be computed again.
      const remake: Remake = (last, more) =>
        state.isStopped ? Promise.resolve(state) : this.remake(last!, edits, more);
      this.history.add({ edits, state, saved: savedState(state), remake });
      const old = new Set(netKeys(before.result));
      const changed = netKeys(state.result).flatMap((key, i) => (old.has(key) ? [] : [i + 1]));
      return { ok: true, changed };
    });
  }

  /** Takes the last edit back; false if there is none. */
  undo(): boolean {
    return this.history?.move(-1) ?? false;
  }

  /** Makes the edit that was taken back last again; false if there is none. */
  redo(): boolean {
    return this.history?.move(1) ?? false;
  }

  /** What came out, as plain data. Cost: none, unless it must be computed again. */
  result(work: WorkOptions = {}): Promise<TimedResult> {
    return this.inTurn(async () => (await this.shown(work)).result);
  }

  /** What was asked for and what came of it. Cost as `result`. @internal */
  state(work: WorkOptions = {}): Promise<DocumentState> {
    return this.inTurn(() => this.shown(work));
  }

  /** Draws all sheets, ready to be written in any format. @internal */
  print(options: Options = {}, work: WorkOptions = {}): Promise<Print> {
    return this.inTurn(async () => (await this.printed(options, work)).print);
  }

  /**
   * Writes the nets: `pdf`, `svg`, `dxf` or `png` (a file for each sheet), `fold` or `glb` (the folding
   * as an animation). With options that concern sheets, size or flaps they are laid out for this alone.
   * `foldwright` is the document itself, with its history, for `open`; it does not ask for options.
   */
  export(
    format: ExportFormat,
    options: Options = {},
    work: WorkOptions = {},
  ): Promise<WrittenFile[]> {
    return this.inTurn(async () => {
      if (format === 'foldwright') {
        const { writeProject } = await import('../project/write-project.js');
        return [{ name: this.title + projectEnding, bytes: writeProject(this.project()) }];
      }
      const { result, print } = await this.printed(options, work);
      return writeFiles(format, { result, print, name: `${this.title}.${format}` });
    });
  }

  /** The document as it can be kept. @throws Error before the first run @internal */
  project(): Project {
    if (!this.history || !this.asked) throw new Error(nothing);
    const { position: cursor, saved: states, steps } = this.history;
    const { files, title: name } = this;
    const options = savedSettings(this.asked);
    return { app: version, name, files, options, steps, cursor, states };
  }

  /** Ends the session and the workers that were started for it. */
  close(): void {
    this.surroundings.close?.();
  }

  /** Name of the model's file without its ending; before the first run, by what the files are called. */
  get title(): string {
    return titleOf(this.fileName ?? probableModel(this.files));
  }

  private async begin(settings: Settings, work: RunWork): Promise<Report> {
    const beginning = await beginningOf(this.model, freshWishes(settings), work);
    const run = (more: RunWork): Promise<TimedResult> => beginning.run(more);
    const { result, isWhole } = await outcome(run, work);
    const { told, wishes } = beginning;
    this.fileName = result.file;
    this.asked = settings;
    const stateOf = (made: TimedResult): DocumentState => {
      const notices = [...(isWhole ? [] : [stopped]), ...told, ...made.notices];
      const start = startAgain(made, null);
      return { wishes, result: { ...made, notices }, start, isStopped: !isWhole };
    };
    const first = stateOf(result);
    // What an ended run has found depends on when it was ended: it cannot be computed again.
    const remake: Remake = async (_, more) => (isWhole ? stateOf(await run(more)) : first);
    this.history = new History([{ edits: [], remake, state: first, saved: savedState(first) }], 0, {
      reportOf: stateReport,
    });
    return this.history.report;
  }

  /** Takes the document of a project; nothing is computed yet. */
  private reopen(opened: OpenedProject): void {
    const { cursor, steps, states } = opened.project;
    this.asked = opened.settings;
    const remakes: Remake[] = [
      (_, work) => opened.run(work),
      ...steps.map(
        (edits): Remake =>
          (state, work) =>
            this.remake(state!, edits, work),
      ),
    ];
    const all = remakes.map((remake, i) => {
      return { edits: steps[i - 1] ?? [], remake, state: null, saved: states[i] ?? null };
    });
    this.history = new History(all, cursor, {
      reportOf: stateReport,
      restore: async (saved, work) => {
        const state = await opened.restore(saved, work);
        if (state) this.fileName = state.result.file;
        return state;
      },
      refused: (count) =>
        opened.tell({ code: 'project-damaged', params: { what: 'refused', count } }),
    });
  }

  /** A state that was dropped, from the one before; null if the engine refuses the edits now. */
  private async remake(
    before: DocumentState,
    edits: readonly DocumentEdit[],
    work: WorkOptions,
  ): Promise<DocumentState | null> {
    const plan = planEdits(before, edits);
    const made = plan.ok ? await this.make(before, plan, work) : plan;
    return 'ok' in made ? null : made;
  }

  private async current(work: WorkOptions): Promise<DocumentState> {
    if (!this.history) throw new Error(nothing);
    return this.history.current(work);
  }

  /** With all that its sheets are made of. */
  private async shown(work: WorkOptions): Promise<DocumentState> {
    return this.lit.of(await this.current(work), work);
  }

  private async printed(
    options: Options,
    work: WorkOptions,
  ): Promise<{ result: TimedResult; print: Print }> {
    const before = await this.current(work);
    const settings = changedSettings(before.wishes.settings, options);
    const wishes = { ...before.wishes, settings };
    const isSameJob = JSON.stringify(jobOf(wishes)) === JSON.stringify(jobOf(before.wishes));
    const laidOut = isSameJob
      ? before.result
      : await this.job(jobOf(wishes), startFrom(before.result, []), work);
    const { result } = await this.lit.of({ wishes, result: laidOut }, work);
    const { margin } = settings;
    const { loadFont, loadRenderer } = this.surroundings;
    // Loaded when it is first asked for: who only edits does not draw.
    const { preparePrint } = await import('../export/print.js');
    const look = { title: this.title, margin, options: printOf(wishes) };
    const print = await preparePrint({ result, ...look, loadFont, loadRenderer });
    return { result, print };
  }

  /** The state that a plan makes, or why the engine refuses. */
  private async make(
    before: DocumentState,
    { wishes, start, seed }: EditPlan,
    work: RunWork,
  ): Promise<DocumentState | Refusal> {
    if (!start) return { ...before, wishes };
    const options = { ...jobOf(wishes), ...(seed !== undefined && { seed }) };
    try {
      const { isWhole, ...made } = await outcome((more) => this.job(options, start, more), work);
      const own = [...(isWhole ? [] : [stopped]), ...made.result.notices];
      const notices = withLasting(own, before, wishes.settings);
      const result = { ...together(before.result, made.result), notices };
      const settled = { wishes: settledWishes(wishes, { result }), result };
      return { ...settled, start: startAgain(result, start), isStopped: !isWhole };
    } catch (error) {
      if (!(error instanceof JobError) || crashes.includes(error.code)) throw error;
      return refusalOf(error, error.faces);
    }
  }

  private job(options: JobOptions, start: JobStart | null, work: RunWork): Promise<TimedResult> {
    return this.model.run(options, { ...work, ...(start && { start }) });
  }

  private inTurn<Value>(work: () => Promise<Value>): Promise<Value> {
    const turn = this.lastWork.then(work);
    this.lastWork = turn.catch(() => undefined);
    return turn;
  }
}
