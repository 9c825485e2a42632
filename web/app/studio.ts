import type { Pool } from '../core/pool.js';
import type { TimedEvent } from '../core/protocol.js';
import { differentlyNamed, renamed, startFrom } from '../model/edits.js';
import type { JobResult, PartName } from '../model/job.js';
import { missingSupport } from './browser-support.js';
import { find } from './dom.js';
import { DownloadBar } from './download-bar.js';
import { FilePicker } from './file-picker.js';
import { HatchSwitch } from './hatch-switch.js';
import { JobRunner, type Outcome } from './job-runner.js';
import { MessagePanel } from './message-panel.js';
import { readModelFile, UnusableChoice, type ModelFile } from './model-file.js';
import { OptionsForm, type Wishes } from './options-form.js';
import { partNumbers, PartsPanel, type Change } from './parts-panel.js';
import { PrintPanel } from './print-panel.js';
import { ProgressPanel } from './progress-panel.js';
import { type FinishedRun, ResultPanel } from './result-panel.js';
import { RunHistory } from './run-history.js';
import { SampleGallery } from './sample-gallery.js';
import { sentence } from './sentence.js';
import { SheetList } from './sheet-list.js';
import { StepsPanel } from './steps-panel.js';
import { Workshop } from './workshop.js';

/** Ms after the page is complete: its pictures shall be there first. */
const preparation = 300;

/** Ms before the progress of naming is shown: most of the time it is done by then. */
const namingPatience = 500;

/** Parts of the later result that have faces of what a change of the earlier one named. */
function touched(before: JobResult, after: JobResult, { edits }: Change): number[] {
  const named = new Set(edits.flatMap(({ parts }) => parts));
  return [...new Set(after.labels.filter((_, face) => named.has(before.labels[face]!)))];
}

/** Ties the parts of the page together: a choice starts a run, a run ends in a result or a message. */
export class Studio {
  private readonly runner: JobRunner;
  private readonly message = new MessagePanel();
  private readonly form = new OptionsForm(() => void this.unfold());
  private readonly gallery = new SampleGallery((model) => void this.choose(model));
  private readonly progress = new ProgressPanel(() => this.runner.cancel());
  private readonly workshop: Workshop;
  private readonly result: ResultPanel;
  private readonly parts: PartsPanel;
  private readonly history = new RunHistory();
  private readonly chosen = find('#chosen', HTMLElement);
  private readonly welcome = find('#welcome', HTMLElement);
  private model: ModelFile | null = null;
  /** Names that are being given to the parts of the result; null if none are. */
  private naming: PartName[] | null = null;
  /** The end of the last naming. */
  private named = Promise.resolve();
  /** Counts choices: a file that is slower to read than a later choice is dropped. */
  private choices = 0;

  constructor(private readonly pool: Pool) {
    this.runner = new JobRunner(pool);
    const downloads = new DownloadBar((format) =>
      this.message.show(`The ${format} file could not be written`, 'The result is still here.'),
    );
    const pick = (part: number): void => this.parts.toggle(part);
    const sheets = new SheetList(pick);
    this.workshop = new Workshop(pick);
    this.parts = new PartsPanel({
      select: (parts) => {
        this.workshop.select(parts);
        sheets.select(parts);
      },
      change: (change) => void this.change(change),
      rename: (part, name) => (this.named = this.rename(part, name)),
      undo: () => void this.undo(),
    });
    const steps = new StepsPanel({
      mark: (marks) => sheets.mark(marks),
      show: (time) => this.workshop.fold(time),
    });
    this.result = new ResultPanel(downloads, sheets, steps, new PrintPanel());
    new HatchSwitch((hatched) => this.workshop.hatch(hatched));
  }

  /** Opens the page for choices, or says why this browser cannot run it. */
  async start(): Promise<void> {
    const missing = missingSupport();
    if (missing !== null) {
      this.message.show('Foldwright cannot run in this browser', missing);
      this.form.close();
      return;
    }
    new FilePicker((files) => void this.choose(readModelFile(files)));
    await this.gallery.load().catch((error: unknown) => this.explain(error));
    // The page is complete now: while a model is being chosen there is time for what a run needs.
    setTimeout(() => {
      this.pool.warm();
      this.workshop.prepare();
    }, preparation);
  }

  /** Takes a model and unfolds it. A choice that is no model leaves the one before in place. */
  private async choose(coming: Promise<ModelFile>): Promise<void> {
    const choice = ++this.choices;
    const model = await coming.catch((error: unknown) => this.explain(error));
    if (!model || choice !== this.choices) return;
    this.model = model;
    this.gallery.mark(model.name);
    this.chosen.textContent = `Chosen: ${model.name}`;
    this.form.ready = true;
    await this.unfold();
  }

  private async unfold(): Promise<void> {
    const { model } = this;
    const wishes = this.form.read();
    if (!model || !wishes) return;
    this.naming = null;
    this.message.clear();
    this.welcome.hidden = true;
    this.progress.begin(model.name);
    this.workshop.begin(model.name);
    this.parts.changing = true;
    const outcome = await this.runner.run(model, wishes.job, (event) => {
      this.progress.follow(event);
      this.workshop.follow(event);
      // The pictures of a run need the room of the last result, which comes back if there is none.
      if (this.workshop.shown) this.result.hide();
    });
    // A later run has ended this one and taken over the panels.
    if (this.runner.running) return;
    this.parts.changing = false;
    await this.finish(outcome, model, wishes);
  }

  private async finish(outcome: Outcome, model: ModelFile, wishes: Wishes): Promise<void> {
    if (outcome.type === 'done') {
      const lead = await this.presentNew({ model, wishes, result: outcome.result });
      if (lead === null) return;
      const { hasFocus } = this.progress;
      this.progress.end(`Done: ${lead}`);
      this.form.action = 'Unfold again';
      if (hasFocus) this.result.focus();
      return;
    }
    if (outcome.type === 'cancelled') {
      this.leave('Cancelled. This is how far it came.', 'Cancelled.');
      // A whole result is worth more than a part of the next one.
      if (!outcome.best || this.result.exists) return;
      const lead = await this.presentNew({ model, wishes, result: outcome.best });
      if (lead !== null) this.progress.end(`Cancelled. ${lead}`);
      return;
    }
    this.leave('This is how far it came.', '');
    const next = outcome.crashed
      ? 'Nothing else is lost, and the next run starts afresh. A smaller model may work.'
      : 'Choose another model, or repair this one and try again.';
    this.message.show(`“${model.name}” could not be unfolded`, sentence(outcome.text), next);
  }

  /** Changes parts of the result; what comes out takes its place. */
  private async change(change: Change): Promise<void> {
    if (this.runner.running && !this.naming) return;
    this.parts.changing = true;
    await this.named;
    const before = this.history.current;
    if (!before || this.runner.running) return;
    const { model, wishes, result } = before;
    const job = { ...wishes.job, names: result.names };
    this.message.clear();
    this.progress.begin(model.name, this.parts.progress);
    const follow = (event: TimedEvent): void => this.progress.follow(event);
    const start = startFrom(result, change.edits);
    const outcome = await this.runner.run(model, job, follow, start);
    if (this.runner.running) return;
    this.parts.changing = false;
    if (this.progress.hasFocus) this.parts.focus();
    if (outcome.type === 'done') {
      const run = { model, wishes, result: outcome.result };
      this.history.add(run, change.words);
      const selected = touched(result, outcome.result, change);
      const lead = await this.present(run, { selected });
      if (lead !== null) this.progress.end(`Done: ${lead}`);
      else if (!this.runner.running) this.history.back();
      return;
    }
    this.progress.end(outcome.type === 'cancelled' ? 'Cancelled. All is as it was.' : '');
    if (outcome.type === 'failed') {
      this.message.show('Nothing was changed', sentence(outcome.text));
    }
  }

  /**
   * Names a part. Only texts on paper change: nets, motions and places are those of the result. A
   * later name does not wait for the ones before, but takes them along.
   */
  private async rename(part: number, name: string): Promise<void> {
    const before = this.history.current;
    if (!before || (this.runner.running && !this.naming)) return;
    const { model, wishes, result } = before;
    const names = renamed(this.naming ?? result.names, part, name);
    const parts = differentlyNamed(result.names, names);
    if (parts.length === 0) return this.runner.cancel();
    this.naming = names;
    this.message.clear();
    const begin = (): void => this.progress.begin(model.name, this.parts.progress);
    const late = setTimeout(begin, namingPatience);
    const follow = (event: TimedEvent): void => this.progress.follow(event);
    const job = { ...wishes.job, names };
    const outcome = await this.runner.run(model, job, follow, startFrom(result, []));
    clearTimeout(late);
    if (this.runner.running) return;
    this.naming = null;
    if (outcome.type !== 'done') return this.keepNames(outcome, before);
    // What was computed for the nets was computed before.
    const { seconds, search } = result;
    const run = { model, wishes, result: { ...outcome.result, seconds, search } };
    this.history.add(run, `${parts.length === 1 ? 'name' : 'names'} of ${partNumbers(parts)}`);
    const selected = this.parts.chosen;
    const lead = await this.present(run, { selected, renamed: true });
    if (lead !== null) this.progress.end(name === '' ? 'The name is gone.' : `Named ${name}.`);
    else if (!this.runner.running) this.history.back();
  }

  /** Ends a naming that came to nothing. */
  private keepNames(outcome: Outcome, { result }: FinishedRun): void {
    this.progress.end('');
    if (outcome.type === 'failed') this.parts.refuse(sentence(outcome.text));
    else this.parts.offer(result, this.history.undo, this.parts.chosen);
  }

  /** Takes the last change back. */
  private async undo(): Promise<void> {
    // A name that nobody has seen yet is not what shall be taken back.
    if (this.naming) this.runner.cancel();
    await this.named;
    if (this.runner.running) return;
    const run = this.history.back();
    if (!run) return;
    this.message.clear();
    this.parts.focus();
    const lead = await this.present(run);
    if (lead !== null) this.progress.end(`Undone: ${lead}`);
  }

  /** Shows a result that was not made of the one before. */
  private presentNew(run: FinishedRun): Promise<string | null> {
    this.history.begin(run);
    return this.present(run);
  }

  /** Ends a run without a result: keeps its pictures with a note, or shows what was there before. */
  private leave(note: string, announcement: string): void {
    const { hasFocus } = this.progress;
    this.result.restore();
    this.welcome.hidden = this.result.shown || this.workshop.shown;
    if (hasFocus) this.form.focus();
    this.workshop.stop(note);
    this.progress.end(announcement);
  }

  /**
   * Shows nets and model; null if they could not be drawn, or if a run has begun meanwhile, whose
   * panels these are then.
   *
   * @param how.selected parts that are chosen at first
   * @param how.renamed all but names is as it was
   */
  private async present(
    run: FinishedRun,
    { selected = [], renamed = false }: { selected?: number[]; renamed?: boolean } = {},
  ): Promise<string | null> {
    const lead = await this.result.show(run, renamed).catch((error: unknown) => {
      console.error(error);
      if (this.runner.running) return null;
      this.leave('The nets were found, but not drawn.', '');
      this.message.show(
        `The sheets of “${run.model.name}” could not be drawn`,
        'Try it once more.',
      );
      return null;
    });
    if (lead === null || this.runner.running) return null;
    if (renamed) this.workshop.rename(run.result.pieces);
    else this.workshop.finish(run.result);
    this.parts.offer(run.result, this.history.undo, selected);
    await this.result.complete();
    return this.runner.running ? null : lead;
  }

  /** Tells a failed choice; anything else is a fault of the page and goes on as one. */
  private explain(error: unknown): void {
    if (!(error instanceof UnusableChoice)) throw error;
    this.message.show('Nothing was unfolded', error.message);
  }
}
