import type { Pool } from '../core/pool.js';
import type { TimedEvent } from '../core/protocol.js';
import { differentlyNamed, renamed, startFrom } from '../model/edits.js';
import type { JobResult, PartName } from '../model/job.js';
import { missingSupport } from './browser-support.js';
import { DownloadBar } from './download-bar.js';
import { FilePicker } from './file-picker.js';
import type { FinishedRun } from './finished-run.js';
import { HatchSwitch } from './hatch-switch.js';
import { type Failure, JobRunner, type Outcome } from './job-runner.js';
import { MessagePanel } from './message-panel.js';
import { ModelChoice } from './model-choice.js';
import { fetchModelFile, readModelFile, UnusableChoice, type ModelFile } from './model-file.js';
import { OptionsForm, type Preset } from './options-form.js';
import { Panel } from './panel.js';
import { partNumbers, PartsPanel, type Change } from './parts-panel.js';
import { PendingSettings } from './pending-settings.js';
import type { StudioPlace } from './place.js';
import { ProgressPanel } from './progress-panel.js';
import { ResultPanel } from './result-panel.js';
import { RunHistory } from './run-history.js';
import { SampleGallery } from './sample-gallery.js';
import { sentence } from './sentence.js';
import { SheetList } from './sheet-list.js';
import { StepsPanel } from './steps-panel.js';
import { Workshop } from './workshop.js';

/** Ms after the studio is complete: its pictures shall be there first. */
const preparation = 300;

/** Ms before the progress of naming is shown: most of the time it is done by then. */
const namingPatience = 500;

/** What a person can do about a failure. */
const nextSteps: Readonly<Record<Failure['cause'], string>> = {
  file: 'Choose another model, or repair this one and try again.',
  job: 'Change the settings and try again, or choose another model.',
  crash: 'Nothing else is lost, and the next run starts afresh. A smaller model may work.',
};

/** Parts of the later result that have faces of what a change of the earlier one named. */
function touched(before: JobResult, after: JobResult, { edits }: Change): number[] {
  const named = new Set(edits.flatMap(({ parts }) => parts));
  return [...new Set(after.labels.filter((_, face) => named.has(before.labels[face]!)))];
}

export interface StudioListener {
  /** The studio is complete, and begins to load what a run needs. */
  onReady(): void;
  /** What runs tell. */
  onEvent(event: TimedEvent): void;
}

/** Ties the panels together: a choice starts a run, a run ends in a result or a message. */
export class Studio extends Panel {
  private readonly runner: JobRunner;
  private readonly message = new MessagePanel(this.place);
  private readonly form = new OptionsForm(this.place, () => void this.unfold());
  private readonly settings = new PendingSettings(this.place);
  private readonly gallery = new SampleGallery(this.place, (model) => {
    void this.choose(model);
  });
  private readonly choice = new ModelChoice(this.place, this.form, this.gallery);
  private readonly progress = new ProgressPanel(this.place, () => this.runner.cancel());
  private readonly workshop: Workshop;
  private readonly result: ResultPanel;
  private readonly parts: PartsPanel;
  private readonly history = new RunHistory();
  private readonly welcome = this.find('#welcome', HTMLElement);
  /** Names that are being given to the parts of the result; null if none are. */
  private naming: PartName[] | null = null;
  /** The end of the last naming. */
  private named = Promise.resolve();
  /** Whether this browser can run it. */
  private isOpen = false;
  /** Counts choices: a file that is slower to read than a later choice is dropped. */
  private choices = 0;

  /** @param engine gives the workers; is not asked before the studio has use for them */
  constructor(
    place: StudioPlace,
    private readonly engine: () => Pool,
    private readonly listener: StudioListener,
  ) {
    super(place);
    this.runner = new JobRunner(engine, place.life, (event) => listener.onEvent(event));
    const downloads = new DownloadBar(place, (format) =>
      this.message.show(`The ${format} file could not be written`, 'The result is still here.'),
    );
    const pick = (part: number): void => this.parts.toggle(part);
    const sheets = new SheetList(place, pick);
    this.workshop = new Workshop(place, pick);
    this.parts = new PartsPanel(place, {
      select: (parts) => {
        this.workshop.select(parts);
        sheets.select(parts);
      },
      change: (change) => void this.change(change),
      rename: (part, name) => (this.named = this.rename(part, name)),
      undo: () => void this.undo(),
    });
    const steps = new StepsPanel(place, {
      mark: (marks) => sheets.mark(marks),
      show: (time) => this.workshop.fold(time),
    });
    this.result = new ResultPanel(place, downloads, sheets, steps);
    new HatchSwitch(place, (hatched) => this.workshop.hatch(hatched));
  }

  /** Opens the studio for choices, or says why this browser cannot run it. */
  async start(): Promise<void> {
    const missing = missingSupport();
    if (missing !== null) {
      this.message.show('Foldwright cannot run in this browser', missing);
      this.form.close();
      return;
    }
    this.isOpen = true;
    new FilePicker(this.place, (files) => void this.choose(readModelFile(files)));
    await this.gallery.load().catch((error: unknown) => this.explain(error));
    // All is there now: while a model is being chosen there is time for what a run needs.
    setTimeout(() => this.prepare(), preparation);
  }

  /** Fills in the fields for which there are values, and leaves the others as they are. */
  preset(values: Preset): void {
    this.form.preset(values);
  }

  /** Fetches a model from an address, which may be relative to `base`, and unfolds it. */
  load(address: string, base: string): void {
    if (this.isOpen) void this.choose(fetchModelFile(address, base, this.place.life));
  }

  /** Takes a model and unfolds it. A choice that is no model leaves the one before in place. */
  private async choose(coming: Promise<ModelFile>): Promise<void> {
    const number = ++this.choices;
    const model = await coming.catch((error: unknown) => this.explain(error));
    if (!model || number !== this.choices) return;
    this.choice.take(model);
    await this.unfold();
  }

  private prepare(): void {
    if (this.place.life.aborted) return;
    this.engine().warm();
    this.workshop.prepare();
    this.listener.onReady();
  }

  private async unfold(): Promise<void> {
    const { model } = this.choice;
    const wishes = this.form.read();
    if (!model || !wishes) return;
    this.naming = null;
    this.message.clear();
    this.welcome.hidden = true;
    this.choice.open();
    this.progress.begin(model.name);
    const settings = this.settings.read();
    this.settings.compareWith(settings);
    const pictures = this.workshop.begin(model.name);
    this.parts.changing = true;
    const outcome = await this.runner.run(model, wishes.job, (event) => {
      if (event.type === 'model') this.choice.accept();
      this.progress.follow(event);
      this.workshop.follow(event);
      // The pictures of a run need the room of the last result, which comes back if there is none.
      if (this.workshop.shown) this.result.hide();
    });
    // A later run has ended this one and taken over the panels.
    if (this.runner.running) return;
    if (outcome.type === 'failed') return this.fail(outcome, model);
    this.choice.leave();
    await this.finish(outcome, { model, wishes, settings, pictures });
  }

  /** Presents what came out. */
  private async finish(
    outcome: Exclude<Outcome, Failure>,
    from: Omit<FinishedRun, 'result'>,
  ): Promise<void> {
    const isDone = outcome.type === 'done';
    // A whole result is worth more than a part of the next one.
    const result = isDone ? outcome.result : this.result.exists ? null : outcome.best;
    if (!result) return this.leave('Cancelled. This is how far it came.', 'Cancelled.');
    const run = { ...from, result };
    const lead = await this.present(run, () => this.history.begin(run));
    if (lead === null) return;
    const { hasFocus } = this.progress;
    this.progress.end(isDone ? `Done: ${lead}` : `Cancelled. ${lead}`);
    this.form.action = 'Unfold again';
    if (hasFocus) this.result.focus();
  }

  /** Says why nothing came out. A file that cannot be read is not the chosen one any more. */
  private fail({ cause, text }: Failure, model: ModelFile): void {
    if (cause === 'file') this.choice.drop();
    else this.choice.leave();
    this.leave('This is how far it came.', '');
    const before = this.history.current;
    const rest = before ? [`What is below is still the result of “${before.model.name}”.`] : [];
    const headline = `“${model.name}” could not be unfolded`;
    this.message.show(headline, sentence(text), nextSteps[cause], ...rest);
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
    const { hasFocus } = this.progress;
    if (outcome.type === 'done') {
      const run = { ...before, result: outcome.result };
      const selected = touched(result, outcome.result, change);
      const enter = (): void => this.history.add(run, change.words);
      const lead = await this.present(run, enter, { selected });
      if (lead !== null) this.progress.end(`Done: ${lead}`);
      if (lead !== null && hasFocus) this.parts.focus();
      return;
    }
    this.parts.changing = false;
    if (hasFocus) this.parts.focus();
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
    // Names that are being drawn already are those of the result in a moment.
    if (this.naming && !this.runner.running) await this.named;
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
    if (outcome.type !== 'done') return this.keepNames(outcome, before);
    // What was computed for the nets was computed before.
    const { seconds, search } = result;
    const run = { ...before, result: { ...outcome.result, seconds, search } };
    const words = `${parts.length === 1 ? 'name' : 'names'} of ${partNumbers(parts)}`;
    const enter = (): void => this.history.add(run, words);
    const selected = this.parts.chosen;
    const lead = await this.present(run, enter, { selected, renamed: true });
    if (this.runner.running) return;
    this.naming = null;
    if (lead !== null) this.progress.end(name === '' ? 'The name is gone.' : `Named ${name}.`);
  }

  /** Ends a naming that came to nothing. */
  private keepNames(outcome: Outcome, { result }: FinishedRun): void {
    this.naming = null;
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
    const run = this.history.before;
    if (!run) return;
    this.message.clear();
    this.parts.focus();
    this.parts.changing = true;
    const lead = await this.present(run, () => this.history.back());
    if (lead !== null) this.progress.end(`Undone: ${lead}`);
  }

  /**
   * Ends a run without a result: the result before comes back whole, or else the pictures of the run
   * stay with a note.
   */
  private leave(note: string, announcement: string): void {
    const { hasFocus } = this.progress;
    const before = this.history.current;
    if (before) this.comeBack(before);
    else this.workshop.stop(note);
    this.settings.compareWith(before?.settings ?? null);
    this.parts.changing = false;
    this.welcome.hidden = before !== null || this.workshop.shown;
    if (hasFocus) this.form.focus();
    this.progress.end(announcement);
  }

  /** Another run may have used the panels of the result that is on the page. */
  private comeBack({ pictures, result }: FinishedRun): void {
    if (!this.workshop.shows(pictures)) {
      this.workshop.finish(pictures, result);
      this.workshop.select(this.parts.chosen);
    }
    this.result.restore();
  }

  /**
   * Shows nets and model; null if they could not be drawn, or if a run has begun meanwhile, whose
   * panels these are then.
   *
   * @param enter puts the run into the history
   * @param how.selected parts that are chosen at first
   * @param how.renamed all but names is as it was
   */
  private async present(
    run: FinishedRun,
    enter: () => void,
    { selected = [], renamed = false }: { selected?: number[]; renamed?: boolean } = {},
  ): Promise<string | null> {
    const drawn = await this.result.draw(run).catch((error: unknown) => {
      console.error(error);
      if (!this.runner.running) this.tellUndrawn(run);
      return null;
    });
    if (drawn === null || this.runner.running) return null;
    // All at once: no two panels may ever show different runs.
    enter();
    const lead = this.result.show(drawn, renamed);
    if (renamed) this.workshop.rename(run.result.pieces);
    else this.workshop.finish(run.pictures, run.result);
    this.settings.compareWith(run.settings);
    this.parts.offer(run.result, this.history.undo, selected);
    this.parts.changing = false;
    await this.result.complete();
    return this.runner.running ? null : lead;
  }

  private tellUndrawn({ model }: FinishedRun): void {
    this.leave('The nets were found, but not drawn.', '');
    this.message.show(`The sheets of “${model.name}” could not be drawn`, 'Try it once more.');
  }

  /** Tells a failed choice; anything else is a fault of the page and goes on as one. */
  private explain(error: unknown): void {
    if (!(error instanceof UnusableChoice)) throw error;
    this.message.show('Nothing was unfolded', error.message);
  }
}
