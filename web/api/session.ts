import { version } from '../../package.json';
import type { TimedResult } from '../core/client.js';
import { JobError, engineDied } from '../core/job-error.js';
import type { Pool } from '../core/pool.js';
import type { TimedEvent } from '../core/protocol.js';
import { writeFiles } from '../export/files.js';
import type { FontLoader } from '../export/font-loader.js';
import type { RendererLoader } from '../export/renderer-loader.js';
import type { ExportFormat, WrittenFile } from '../export/formats.js';
import type { Print } from '../export/print.js';
import { makeReport, type Report } from '../export/report.js';
import { echo, type Settings } from '../model/options.js';
import type { DocumentEdit } from '../model/document-edits.js';
import { startFrom } from '../model/edits.js';
import type { JobResult, JobStart } from '../model/job.js';
import type { JobOptions } from '../model/job-options.js';
import { probableModel, type ModelFiles } from '../model/model-files.js';
import { addSeconds } from '../model/stage-seconds.js';
import { changedSettings, defaultSettings, type Options } from './written-options.js';
import { freshWishes, jobOf, printOf, type DocumentState } from './document-state.js';
import {
  planEdits,
  refusal,
  refusalOf,
  settledWishes,
  type EditPlan,
  type Refusal,
} from './edit-plan.js';
import { beginningOf } from './file-nets.js';
import { History } from './history.js';
import { inspectModel, type Inspection } from './inspect.js';
import { OpenedModel } from './opened-model.js';
import { readEdits } from './read-edits.js';
import type { RunWork, WorkOptions } from './work.js';

/** An edit that was made. */
export interface Applied {
  ok: true;
  /** Pieces that were not there before, counted from 1 in the order of gluing. */
  changed: number[];
}

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

/** Identifies the net of each piece by its faces and folds. */
function netKeys({ nets, pieces }: TimedResult): string[] {
  return nets.slice(0, pieces.length).map(({ faces, folds }) => `${faces.join()}|${folds.join()}`);
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

  constructor(
    private readonly files: ModelFiles,
    private readonly surroundings: Surroundings,
  ) {
    this.model = new OpenedModel(files, surroundings.pool);
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
    return this.history?.before?.result ?? null;
  }

  /** The edits that redo would make again; null if there are none. */
  get nextStep(): readonly DocumentEdit[] | null {
    return this.history?.next ?? null;
  }

  /** What came out, as the command line reports it. @throws Error before the first run */
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
    options: Pick<Options, 'faces' | 'up'> = {},
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
    work: WorkOptions = {},
  ): Promise<Applied | Refusal> {
    return this.inTurn(async () => {
      const edits = readEdits(Array.isArray(edit) ? edit : [edit]);
      if (!this.history) throw new Error(nothing);
      const before = await this.history.current(work);
      const plan = planEdits(before, edits);
      if (!plan.ok) return plan;
      const { position } = this.history;
      const made = await this.make(before, plan, work);
      if ('ok' in made) return made;
      if (this.history.position !== position) {
        return refusal('overtaken', {});
      }
      this.history.add(edits, made, (state, more) => this.remake(state!, edits, more));
      const old = new Set(netKeys(before.result));
      const changed = netKeys(made.result).flatMap((key, i) => (old.has(key) ? [] : [i + 1]));
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
    return this.inTurn(async () => (await this.current(work)).result);
  }

  /** What was asked for and what came of it. Cost as `result`. @internal */
  state(work: WorkOptions = {}): Promise<DocumentState> {
    return this.inTurn(() => this.current(work));
  }

  /** Draws all sheets, ready to be written in any format. @internal */
  print(options: Options = {}, work: WorkOptions = {}): Promise<Print> {
    return this.inTurn(async () => (await this.printed(options, work)).print);
  }

  /**
   * Writes the nets: `pdf`, `svg`, `dxf` or `png` (a file for each sheet), `fold` or `glb` (the folding
   * as an animation). With options that concern sheets, size or flaps they are laid out for this alone.
   */
  export(
    format: ExportFormat,
    options: Options = {},
    work: WorkOptions = {},
  ): Promise<WrittenFile[]> {
    return this.inTurn(async () => {
      const { state, print } = await this.printed(options, work);
      return writeFiles(format, { result: state.result, print, name: `${this.title}.${format}` });
    });
  }

  /** Ends the session and the workers that were started for it. */
  close(): void {
    this.surroundings.close?.();
  }

  /** Name of the model's file without its ending; before the first run, by what the files are called. */
  get title(): string {
    const name = this.fileName ?? probableModel(this.files);
    return name.replace(/^.*[/\\]/, '').replace(/(?<=.)\.[^.]*$/, '');
  }

  private async begin(settings: Settings, work: RunWork): Promise<Report> {
    const beginning = await beginningOf(this.model, freshWishes(settings), work);
    const run = (more: WorkOptions): Promise<TimedResult> => beginning.run(more);
    const { result, isWhole } = await outcome(run, work);
    const { wishes } = beginning;
    this.fileName = result.file;
    const first: DocumentState = { wishes, result };
    // What an ended run has found depends on when it was ended: it cannot be computed again.
    const remake = async (_: unknown, more: WorkOptions): Promise<DocumentState> =>
      isWhole ? { wishes, result: await run(more) } : first;
    this.history = new History(first, remake, (state) => this.reportOf(state));
    return this.history.report;
  }

  /** A state that was dropped, from the one before. */
  private async remake(
    before: DocumentState,
    edits: readonly DocumentEdit[],
    work: WorkOptions,
  ): Promise<DocumentState> {
    const plan = planEdits(before, edits);
    const made = plan.ok ? await this.make(before, plan, work) : plan;
    if ('ok' in made) throw new Error(`An edit cannot be made again: ${made.code}`);
    return made;
  }

  private async current(work: WorkOptions): Promise<DocumentState> {
    if (!this.history) throw new Error(nothing);
    return this.history.current(work);
  }

  private async printed(
    options: Options,
    work: WorkOptions,
  ): Promise<{ state: DocumentState; print: Print }> {
    const before = await this.current(work);
    const settings = changedSettings(before.wishes.settings, options);
    const wishes = { ...before.wishes, settings };
    const isSameJob = JSON.stringify(jobOf(wishes)) === JSON.stringify(jobOf(before.wishes));
    const result = isSameJob
      ? before.result
      : await this.job(jobOf(wishes), startFrom(before.result, []), work);
    const { margin } = settings;
    const { loadFont, loadRenderer } = this.surroundings;
    // Loaded when it is first asked for: who only edits does not draw.
    const { preparePrint } = await import('../export/print.js');
    const look = { title: this.title, margin, options: printOf(wishes) };
    const print = await preparePrint({ result, ...look, loadFont, loadRenderer });
    return { state: { wishes, result }, print };
  }

  /** The state that a plan makes, or why the engine refuses. */
  private async make(
    before: DocumentState,
    { wishes, start, seed }: EditPlan,
    work: WorkOptions,
  ): Promise<DocumentState | Refusal> {
    if (!start) return { wishes, result: before.result };
    const options = { ...jobOf(wishes), ...(seed !== undefined && { seed }) };
    try {
      const result = together(before.result, await this.job(options, start, work));
      return { wishes: settledWishes(wishes, { result }), result };
    } catch (error) {
      if (!(error instanceof JobError) || crashes.includes(error.code)) throw error;
      return refusalOf(error, error.faces);
    }
  }

  private job(
    options: JobOptions,
    start: JobStart | null,
    work: WorkOptions,
  ): Promise<TimedResult> {
    return this.model.run(options, { ...work, ...(start && { start }) });
  }

  private reportOf({ wishes, result }: DocumentState): Report {
    const options = Object.fromEntries(
      Object.entries(echo(wishes.settings)).filter(([name]) => name !== 'workers'),
    );
    const job = jobOf(wishes);
    return makeReport({
      version,
      options,
      job,
      files: [],
      result,
      printed: [],
      seconds: result.seconds,
    });
  }

  private inTurn<Value>(work: () => Promise<Value>): Promise<Value> {
    const turn = this.lastWork.then(work);
    this.lastWork = turn.catch(() => undefined);
    return turn;
  }
}

/** What a run comes to; the nets so far of one that was ended, if they shall be kept. */
async function outcome(
  run: (work: WorkOptions) => Promise<TimedResult>,
  { keepBest = false, ...work }: RunWork,
): Promise<{ result: TimedResult; isWhole: boolean }> {
  let best: TimedResult | null = null;
  const onEvent = (event: TimedEvent): void => {
    if (event.type === 'cancelled' && event.best) best = { ...event.best, seconds: event.seconds };
    work.onEvent?.(event);
  };
  try {
    return { result: await run({ ...work, onEvent }), isWhole: true };
  } catch (error) {
    if (!keepBest || !best || !work.signal?.aborted) throw error;
    return { result: best, isWhole: false };
  }
}

/** A result, with what went into the one that it was made of. */
function together(before: TimedResult, result: TimedResult): TimedResult {
  const { generations, moves } = before.search;
  return {
    ...result,
    search: {
      generations: generations + result.search.generations,
      moves: moves + result.search.moves,
    },
    seconds: addSeconds(before.seconds, result.seconds),
  };
}
