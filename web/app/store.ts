import type { CarriedEdits } from '../api/carry-edits.js';
import type { TimedEvent } from '../core/protocol.js';
import type { DocumentEdit } from '../model/document-edits.js';
import { isNamed, isRenaming } from '../model/edits.js';
import type { JobResult } from '../model/job.js';
import type { PartName } from '../model/job-options.js';
import type { Settings } from '../model/options.js';
import type { Check } from './check.js';
import { Choice } from './choice.js';
import { touchedParts } from './edit-words.js';
import type { Ending } from './ending.js';
import { editedRun, type FinishedRun } from './finished-run.js';
import { Inspector } from './inspector.js';
import type { ChosenModel } from './model-file.js';
import type { FieldValues } from './pending-settings.js';
import { OnPage, type Presented } from './on-page.js';
import { paceOf, type Pace, type Step } from './pace.js';
import { PendingSteps } from './pending-steps.js';
import { replacing, unfolding, type NextRun } from './next-run.js';
import { never } from './place.js';
import type { Aspect, Wishes } from './quick-looks.js';
import { finishedParts } from './result-words.js';
import { RunPictures } from './run-pictures.js';
import type { Scene, Topic, Work } from './scene.js';
import type { OpenModel, StoreNeeds } from './store-needs.js';
import { Topics } from './topics.js';
import { WorkEnd } from './work-end.js';
import { makeRun, makeStep, type Watch } from './work-outcome.js';
import type { Project } from '../project/project.js';

/** Gets what the pictures of a run go into. */
type Begin = (pictures: RunPictures) => void;

/**
 * The state of a studio: the model that is chosen, its document with the history, what is being done,
 * and the run on the page. Commands change it, panels hear of it by topics and keep nothing of it. What
 * is on the page and the document's cursor agree whenever nothing is being done.
 */
export class Store {
  readonly choice = new Choice();
  private readonly page = new OnPage();
  private readonly inspector: Inspector;
  private presentScene: Scene = 'welcome';
  private selected: readonly number[] = [];
  private isRunning = false;
  private readonly steps = new PendingSteps();
  private end = new WorkEnd();
  /** Counts runs: one takes over from whatever went on before. */
  private runs = 0;
  /** Counts choices: a file that is slower to read than a later choice is dropped. */
  private choices = 0;
  private readonly topics: Topics<Topic>;

  constructor(private readonly needs: StoreNeeds) {
    this.topics = new Topics(needs.life);
    this.inspector = new Inspector(needs, () => this.notify('check'));
    needs.life.addEventListener('abort', () => this.cancel());
  }

  /** Calls `listener` after every change. */
  on(topic: Topic, listener: () => void): void {
    this.topics.on(topic, listener);
  }

  /** What the page shows; null until there is a result. */
  get run(): FinishedRun | null {
    return this.page.run;
  }

  get work(): Work {
    if (this.isRunning) return 'running';
    return this.steps.isEmpty ? 'idle' : 'editing';
  }

  get scene(): Scene {
    return this.presentScene;
  }

  /** The chosen model before it is unfolded; null until it was looked at. */
  get check(): Check | null {
    return this.inspector.check;
  }

  /** Whether parts cannot be changed now, as their numbers are about to. */
  get busy(): boolean {
    return this.isRunning || this.steps.areHeavy;
  }

  /** Whether undo and redo would be heard. */
  get canMove(): boolean {
    return this.accepts('move');
  }

  /** What undo would take back; null if there is nothing. */
  get undoable(): readonly DocumentEdit[] | null {
    return this.page.undoable;
  }

  /** The result that undo leads to, where it is at hand. */
  get before(): JobResult | null {
    return this.page.before;
  }

  /** What redo would make again; null if there is nothing. */
  get redoable(): readonly DocumentEdit[] | null {
    return this.page.redoable;
  }

  /** Parts that are chosen, from 0, ascending. */
  get selection(): readonly number[] {
    return this.selected;
  }

  /** Names of parts, with those that are on their way to the page. */
  get names(): readonly PartName[] {
    return this.steps.named(this.run?.result.names ?? []);
  }

  /** Takes a model; false if a later choice was quicker. A choice that is no model rejects and changes nothing. */
  async choose(coming: Promise<ChosenModel>): Promise<boolean> {
    const number = ++this.choices;
    const model = await coming;
    if (number !== this.choices) return false;
    this.choice.take(model);
    this.notify('choice');
    return true;
  }

  /**
   * Looks at the chosen model; ends whatever goes on. What was read stays for the run that follows. A file that is
   * no model is not the chosen one any more.
   */
  async inspect(wishes: Wishes): Promise<Ending> {
    const { model } = this.choice;
    if (!model) return { type: 'nothing' };
    const number = this.begin();
    const inspecting = this.inspector.inspect(model, wishes, this.end.left);
    this.choice.open();
    this.presentScene = this.run ? 'result' : 'empty';
    this.notify('choice', 'check', 'work', 'scene');
    return this.ended(number, inspecting);
  }

  /** Lets the chosen file, which brings its nets along, fill the page as it is; ends whatever goes on. */
  showExhibit(): void {
    const { model } = this.choice;
    if (!model?.exhibit) return;
    this.begin();
    this.isRunning = false;
    this.inspector.forget();
    this.choice.accept(model.name);
    this.presentScene = 'exhibit';
    this.selected = [];
    this.notify('choice', 'check', 'work', 'scene', 'selection');
  }

  /** Lets the run before fill the page again. */
  leaveExhibit(): void {
    if (!this.run) return;
    this.selected = [];
    this.presentScene = 'result';
    this.notify('scene', 'selection');
  }

  /** Lets the model that was looked at fill the page, or the run before again. */
  showCheck(isShown: boolean): void {
    if (!this.check) return;
    this.presentScene = isShown ? 'check' : this.restingScene;
    this.notify('scene', 'check');
  }

  /** Shows the model that was looked at with so many triangles, unless it is being unfolded. */
  async preview(aspect: Aspect): Promise<void> {
    if (this.work !== 'idle') return;
    await this.check?.show(aspect);
  }

  select(parts: readonly number[]): void {
    this.selected = [...parts].sort((a, b) => a - b);
    this.notify('selection');
  }

  /** Chooses a part, from 0, or no longer. */
  toggle(part: number): void {
    if (this.busy || part >= (this.run?.result.parts ?? 0)) return;
    const others = this.selected.filter((other) => other !== part);
    this.select(others.length < this.selected.length ? others : [...others, part]);
  }

  /** The document on the page as it can be kept; null until there is one. */
  get document(): Project | null {
    return this.page.document;
  }

  /** Resolves when nothing is being done. */
  async rest(): Promise<void> {
    while (this.work !== 'idle') await new Promise<void>((resolve) => this.on('work', resolve));
  }

  /** Unfolds the chosen model afresh; ends whatever goes on. */
  async unfold(settings: Settings, fields: FieldValues, begin?: Begin): Promise<Ending> {
    const { model } = this.choice;
    if (!model) return { type: 'nothing' };
    return this.showNext(unfolding(model, settings, fields, this.inspector), begin);
  }

  /**
   * Unfolds the chosen model in place of the one on the page, with the same options and with all edits that fit. Undo
   * goes back to the model before, with its edits.
   */
  async replace(begin?: Begin): Promise<{ ending: Ending; carried: CarriedEdits }> {
    const { run, session } = this.page;
    const { model } = this.choice;
    let carried: CarriedEdits = { kept: 0, lost: [] };
    if (!model || !session || !run) return { ending: { type: 'nothing' }, carried };
    this.inspector.forget();
    const next = replacing(model, { session, run }, this.inspector, (made) => (carried = made));
    return { ending: await this.showNext(next, begin), carried };
  }

  /** Lets another run, or a document that was kept, take the place of the one on the page; ends whatever goes on. */
  async showNext(next: NextRun, begin: Begin = () => undefined): Promise<Ending> {
    const number = this.begin();
    const pictures = new RunPictures(next.model.name);
    this.choice.open();
    // A model that is being looked at stays until the run has pictures of its own.
    if (this.presentScene !== 'check') this.presentScene = this.run ? 'result' : 'empty';
    begin(pictures);
    this.notify('choice', 'work', 'scene');
    return this.ended(number, this.runNow(next, pictures));
  }

  /** Ends what is being done; all goes back to what was before. */
  cancel(): void {
    this.end.leave();
    this.check?.stop();
  }

  /**
   * Whether there is something that `stop` would put on the page: nets of a run, or those of a result that lacks parts,
   * for which every edit goes on to look.
   */
  get canStop(): boolean {
    const { result } = this.run ?? {};
    const lacksParts = result && finishedParts(result) < result.parts;
    return (this.isRunning || lacksParts === true) && this.work !== 'idle' && this.end.canStop;
  }

  /** Ends the work and takes the pieces that are there. */
  stop(): void {
    if (this.canStop) this.end.stop();
  }

  /** Makes edits in one go. While parts change their numbers no other edit is taken. */
  apply(edits: readonly DocumentEdit[]): Promise<Ending> {
    const { names } = this;
    if (edits.every((edit) => isNamed(edit, names))) return Promise.resolve({ type: 'nothing' });
    const make: Step['make'] = (session, work) => session.apply(edits, work);
    return this.step({ pace: paceOf(edits), edits, make });
  }

  /** Takes the last edit back, also one that is still on its way to the page. */
  undo(): Promise<Ending> {
    return this.move((session) => session.undo());
  }

  /** Makes the edit again that was taken back last. */
  redo(): Promise<Ending> {
    return this.move((session) => session.redo());
  }

  private move(to: (session: OpenModel) => boolean): Promise<Ending> {
    return this.step({ pace: 'move', edits: [], make: (session) => Promise.resolve(to(session)) });
  }

  /** Ends what is being done for something else, whose number it returns. */
  private begin(): number {
    this.cancel();
    this.end = new WorkEnd();
    this.isRunning = true;
    return ++this.runs;
  }

  private accepts(pace: Pace): boolean {
    return !this.isRunning && this.steps.accept(pace);
  }

  private async runNow(next: NextRun, pictures: RunPictures): Promise<Ending> {
    const made = await makeRun(next, pictures, this.watch());
    if ('type' in made) return made;
    const { run, session, isWhole } = made;
    return this.present(run, { session, isWhole, position: session.position });
  }

  /** For work that begins now. */
  private watch(): Watch {
    const { end } = this;
    return { end, onEvent: (event) => this.follow(event, end) };
  }

  private follow(event: TimedEvent, end: WorkEnd): void {
    if (this.needs.life.aborted) return;
    this.needs.onEvent(event);
    if (end.left.aborted) return;
    if (event.type === 'model' && this.isRunning) {
      this.choice.accept(event.file);
      // What was chosen of a file that was only looked at are no parts of what comes.
      if (this.presentScene === 'exhibit') this.selected = [];
      this.presentScene = 'pictures';
      this.notify('choice', 'scene');
    }
    this.needs.follow(event);
    if (end.follow(event)) this.notify('work');
  }

  /** The end of what `begin` has given a number. A file that cannot be read is not the chosen one any more. */
  private async ended(number: number, work: Promise<Ending>): Promise<Ending> {
    const ending = await work;
    if (this.needs.life.aborted) return never();
    if (number !== this.runs) return { type: 'nothing' };
    this.isRunning = false;
    if (ending.type === 'inspected') this.choice.accept(ending.check.name);
    if (ending.type === 'failed' && ending.cause === 'file') this.choice.drop(ending.code);
    else this.choice.leave();
    this.presentScene = this.restingScene;
    this.notify('choice', 'check', 'work', 'scene');
    return ending;
  }

  /** What fills the page while nothing is being done. */
  private get restingScene(): Scene {
    if (this.run) return 'result';
    if (this.check?.hasToDecide) return 'check';
    if (this.choice.model?.exhibit) return 'exhibit';
    return this.presentScene === 'pictures' ? 'pictures' : 'welcome';
  }

  private async step(step: Step): Promise<Ending> {
    const { session } = this.page;
    if (!session || !this.accepts(step.pace)) return { type: 'nothing' };
    if (this.steps.isEmpty || this.end.stopped.aborted) this.end = new WorkEnd();
    this.steps.add(step);
    this.notify('work');
    try {
      return await this.stepNow(session, step);
    } finally {
      this.steps.remove(step);
      if (this.steps.isEmpty) this.page.comeBack(session);
      this.notify('work');
    }
  }

  private async stepNow(session: OpenModel, step: Step): Promise<Ending> {
    const watch = this.watch();
    const { runs } = this;
    const { outcome, shown } = await this.steps.inTurn(async () => {
      const outcome = await makeStep(session, step, watch);
      // Of the model that the step has led to, which may be another one by the time at which the page shows it.
      return { outcome, shown: this.page.lastOf(session) };
    });
    if (this.needs.life.aborted) return never();
    if ('type' in outcome) return outcome;
    if (!this.run || runs !== this.runs) return { type: 'nothing' };
    const run = editedRun(shown ?? this.run, outcome.state);
    return this.present(run, { session, position: outcome.position, edits: step.edits });
  }

  /** Puts a run on the page once it is drawn, unless later work has taken over by then. */
  private async present(
    run: FinishedRun,
    { session, isWhole = true, position = 0, edits = [] }: Presented,
  ): Promise<Ending> {
    const { runs } = this;
    const drawing = await this.needs.draw(run).catch((error: unknown) => {
      console.error(error);
      return 'failed' as const;
    });
    if (this.needs.life.aborted) return never();
    if (drawing === 'failed') return { type: 'undrawn', run };
    if (drawing && runs !== this.runs) drawing.drop();
    if (!drawing || runs !== this.runs) return { type: 'nothing' };
    const before = this.page.session === session ? this.run : null;
    const isNaming = before !== null && isRenaming(before.result, run.result);
    const isBack = before !== null && before.model.files !== run.model.files;
    if (isBack) this.choice.comeBack(run.model);
    this.page.put(run, session, position);
    this.presentScene = 'result';
    // Nobody shall look for a part that is gone.
    this.selected = this.selected.filter((part) => part < run.result.parts);
    drawing.show({ isRenaming: isNaming });
    this.notify('scene', ...(isBack ? (['choice'] as const) : []));
    if (!isNaming) this.select(before ? touchedParts(before.result, run.result, edits) : []);
    return { type: 'shown', run, isWhole };
  }

  private notify(...topics: Topic[]): void {
    this.topics.tell(topics);
  }
}
