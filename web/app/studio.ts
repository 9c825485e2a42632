import { makeDoor } from '../api/door.js';
import { pageLoader } from '../browser/page-assets.js';
import type { Pool } from '../core/pool.js';
import type { TimedEvent } from '../core/protocol.js';
import type { DocumentEdit } from '../model/document-edits.js';
import { remedyEdits, type Remedy } from '../model/remedies.js';
import type { Settings } from '../model/options.js';
import type { FoldedNets } from '../read/fold/folded-nets.js';
import { changedSettings, type Options } from '../api/written-options.js';
import type { Painted } from '../view/model-message.js';
import type { Message } from '../model/message.js';
import { BadOption } from '../words/bad-option.js';
import { phraseOf } from '../words/phrase.js';
import { askedFields } from './asked-options.js';
import { isSupported } from './browser-support.js';
import { Checking } from './checking.js';
import { ComparisonPanel } from './comparison-panel.js';
import { triangleWords } from './check-words.js';
import { tooManyFaces, type Check } from './check.js';
import { DownloadBar } from './download-bar.js';
import { EdgeTool } from './edge-tool.js';
import type { Ending } from './ending.js';
import { leadOf, wordsFor } from './ending-words.js';
import { ExhibitPanel } from './exhibit-panel.js';
import { FilePicker } from './file-picker.js';
import type { FinishedRun } from './finished-run.js';
import { HatchSwitch } from './hatch-switch.js';
import { lostWords } from './lost-words.js';
import { MessagePanel } from './message-panel.js';
import { ModelChoice } from './model-choice.js';
import {
  fetchModelFile,
  readModelFiles,
  UnusableChoice,
  type ChosenModel,
  type PickedFile,
} from './model-file.js';
import { OptionsForm, type Preset } from './options-form.js';
import { Panel } from './panel.js';
import { PartsPanel } from './parts-panel.js';
import { listenForPaste } from './paste.js';
import { PieceTool } from './piece-tool.js';
import { PendingSettings, type FieldValues } from './pending-settings.js';
import type { StudioPlace } from './place.js';
import { PaperHabit } from './paper-habit.js';
import { PaperFollower } from './paper-follower.js';
import { reopening } from './next-run.js';
import { ReplaceButton } from './replace-button.js';
import { PrintView } from './print-view.js';
import { ProgressPanel } from './progress-panel.js';
import { ProjectDesk } from './project-desk.js';
import { type DrawnRun, ResultPanel } from './result-panel.js';
import { SampleGallery } from './sample-gallery.js';
import { SceneLayout, type Page } from './scene-layout.js';
import { sentence } from './sentence.js';
import { SheetList } from './sheet-list.js';
import { Splitter } from './splitter.js';
import { StepsPanel } from './steps-panel.js';
import { Store } from './store.js';
import type { Drawing } from './store-needs.js';
import { Tabs } from './tabs.js';
import { listenForUndo } from './undo-keys.js';
import { VerdictPanel } from './verdict-panel.js';
import { Workshop } from './workshop.js';

/** Ms after the studio is complete: its pictures shall be there first. */
const preparation = 300;

/** Ms before the progress of a change is shown: most of the time it is done by then. */
const editPatience = 500;

export interface StudioListener {
  /** Whether the browser shall keep the work by itself. */
  readonly keeps: boolean;
  /** The studio is complete, and begins to load what a run needs. */
  onReady(): void;
  /** What runs tell. */
  onEvent(event: TimedEvent): void;
  /** The page on which a model is chosen, or the bench for one, is there. */
  onPage(page: Page): void;
}

/**
 * Ties panels and store together: what a person does becomes a command, and its ending is told in words. Longer than other
 * files: here is all that knows of more than one panel.
 */
export class Studio extends Panel {
  private readonly store: Store;
  private readonly message = new MessagePanel(this.place);
  private readonly form = new OptionsForm(this.place, () => void this.submit());
  private readonly settings = new PendingSettings(this.place);
  private readonly follower = new PaperFollower(this.form, this.settings);
  private readonly gallery = new SampleGallery(this.place, (model) => {
    void this.choose(model);
  });
  private readonly choice = new ModelChoice(this.place, this.form, this.gallery);
  private readonly progress = new ProgressPanel(this.place, {
    cancel: () => this.store.cancel(),
    stop: () => this.store.stop(),
  });
  private readonly workshop: Workshop;
  private readonly checking: Checking;
  private readonly exhibits: ExhibitPanel;
  private readonly result: ResultPanel;
  private readonly parts: PartsPanel;
  private readonly edges: EdgeTool;
  private readonly verdict: VerdictPanel;
  private readonly pieces: PieceTool;
  private readonly desk: ProjectDesk;
  private readonly door = makeDoor({ startPool: () => this.engine(), ...pageLoader });
  private readonly status = this.find('#status', HTMLElement);
  private readonly tabs = new Tabs(this.place);
  private readonly layout: SceneLayout;
  /** Whether this browser can run it. */
  private isOpen = false;

  /** @param engine gives the workers; is not asked before the studio has use for them */
  constructor(
    place: StudioPlace,
    private readonly engine: () => Pool,
    private readonly listener: StudioListener,
  ) {
    super(place);
    this.store = this.makeStore();
    this.desk = new ProjectDesk(place, this.store, {
      open: (coming) => void this.choose(coming),
      tell: (...words) => this.message.show(...words),
      ask: (...words) => this.message.ask(...words),
    });
    const sheets = new SheetList(place, {
      point: (where) => this.pieces.point(this.edges.point(where) ? null : where),
      press: (where, adds) => {
        if (adds || !this.edges.press(where)) this.pieces.press(where, adds);
      },
      reveal: () => this.tabs.show('sheets'),
    });
    new Splitter(place);
    this.layout = new SceneLayout(place, (page) => listener.onPage(page));
    this.edges = new EdgeTool(place, this.store, sheets, {
      lightModel: (lit, from) => this.workshop.light(lit, from),
      change: (edit) => this.edit(this.store.apply([edit]), (run) => this.done(run)),
      alone: () => this.pieces.close(),
      findOther: (name) => this.pieces.findNamed(name),
    });
    this.pieces = new PieceTool(place, this.store, sheets, {
      lightFaces: (faces) => this.workshop.lightFaces(faces),
      change: (edits, words) =>
        this.edit(this.store.apply(edits), (run) => words ?? this.done(run)),
      alone: () => this.edges.close(),
      isTaken: (at, isFinger) => this.edges.holdsFlap(at, isFinger),
    });
    this.workshop = new Workshop(place, {
      point: ({ face, why }) => {
        if (this.store.scene === 'exhibit' && why !== 'over') this.exhibits.press(face);
        if (this.store.scene !== 'result') return;
        if (why === 'over') this.pieces.pointAtFace(face);
        else if (face >= 0) this.pieces.pressFace(face, why === 'add');
      },
      paint: (painted) => void this.paint(painted),
    });
    this.verdict = new VerdictPanel(place, this.store, {
      show: (finding) => this.edges.walkThrough(finding),
      mend: (remedy) => this.mend(remedy),
    });
    this.exhibits = new ExhibitPanel(place, this.store, this.workshop);
    this.checking = new Checking(place, this.store, this.form, this.workshop);
    const steps = new StepsPanel(place, {
      mark: (marks) => sheets.mark(marks),
      markModel: (marks) => this.workshop.markStep(marks),
      show: (time) => this.workshop.fold(time),
    });
    const downloads = new DownloadBar(
      place,
      (format, reason) =>
        this.message.show(
          this.told.run.notWritten(format),
          reason === null ? this.told.run.resultIsHere : sentence(reason),
        ),
      () => paper.range,
    );
    this.result = new ResultPanel(place, downloads, sheets, steps, (look) => this.restyle(look));
    const paper = new PrintView(place, this.store, {
      pages: () => this.result.pages(),
      fail: () => this.message.show(this.told.run.notPrinted, this.told.run.onceMore),
    });
    this.result.onLook = () => void paper.refresh();
    const move = { undo: () => void this.undo(), redo: () => void this.redo() };
    this.parts = new PartsPanel(place, this.store, {
      change: (edits) => void this.change(edits),
      rename: (edit) => void this.rename(edit),
      ...move,
    });
    listenForUndo(place, move);
    new ComparisonPanel(place, this.store, {
      draw: (result) => this.result.sheetsOf(result),
      undo: move.undo,
    });
    new HatchSwitch(place, (hatched) => this.workshop.hatch(hatched));
    this.store.on('choice', () => this.choice.show(this.store.choice));
    this.store.on('work', () => {
      this.progress.canStop = this.store.canStop;
      if (this.store.work === 'idle') void this.result.offerLook();
    });
    this.store.on('scene', () => this.setScene());
    this.store.on('selection', () => {
      this.workshop.select(this.store.selection);
      sheets.select(this.store.selection);
    });
  }

  /** Opens the studio for choices, or says why this browser cannot run it. */
  async start(): Promise<void> {
    if (!isSupported()) {
      this.message.show(this.told.run.noBrowser, this.told.run.browserLacks);
      this.form.close();
      return;
    }
    this.isOpen = true;
    if (this.listener.keeps) {
      new PaperHabit(this.place, this.form);
      void this.desk.keep();
    }
    const take = (files: Promise<readonly PickedFile[]>): void =>
      void this.choose(files.then(readModelFiles));
    new FilePicker(this.place, take);
    listenForPaste(this.place, (files) => take(Promise.resolve(files)));
    new ReplaceButton(this.place, this.store, (files) => void this.replace(readModelFiles(files)));
    await this.gallery.load().catch((error: unknown) => this.explain(error));
    // All is there now: while a model is being chosen there is time for what a run needs.
    setTimeout(() => this.prepare(), preparation);
  }

  /** Fills in the fields for which there are values, and leaves the others as they are. */
  preset(values: Preset): void {
    this.form.preset(values);
  }

  /** Fills in the fields for options as addresses write them; tells what is wrong with them. */
  ask(options: string): void {
    try {
      this.form.fillPaper(askedFields(options));
    } catch (error) {
      if (!(error instanceof BadOption)) throw error;
      this.message.show(sentence(this.told.optionFault(error.params)));
    }
  }

  /** Fetches a model from an address, which may be relative to `base`, and unfolds it. */
  load(address: string, base: string): void {
    if (this.isOpen) void this.choose(fetchModelFile(address, base, this.place.life), false);
  }

  /** What there is to go on with in another studio, once nothing is being computed; null if there is nothing. */
  async handOver(): Promise<ChosenModel | null> {
    await this.store.rest();
    return this.desk.handOver();
  }

  /** Goes on with what another studio has handed over. */
  goOn(work: ChosenModel): void {
    if (this.isOpen) void this.choose(Promise.resolve(work));
  }

  private makeStore(): Store {
    return new Store({
      open: (files) => this.door.open(files, { pool: this.engine }),
      draw: (run) => this.draw(run),
      follow: (event) => {
        this.progress.follow(event);
        if (this.store.work === 'running') this.workshop.follow(event);
      },
      onEvent: (event) => this.listener.onEvent(event),
      life: this.place.life,
    });
  }

  private prepare(): void {
    if (this.place.life.aborted) return;
    this.engine().warm();
    this.workshop.prepare();
    this.listener.onReady();
  }

  private setScene(): void {
    const { scene, run, work } = this.store;
    this.layout.show(scene);
    this.workshop.open = ['pictures', 'check', 'exhibit'].includes(scene);
    this.result.open = scene === 'result';
    // A model that was looked at has had its picture.
    if (scene === 'result' && work === 'idle' && run) this.comeBack(run);
  }

  /** Takes a model and unfolds it, or holds it where there is something to decide before. */
  private async choose(coming: Promise<ChosenModel>, mayHold = true): Promise<void> {
    const unpacked = coming.then((model) => this.desk.unpacked(model));
    const isTaken = await this.store
      .choose(unpacked)
      .catch((error: unknown) => this.explain(error));
    if (isTaken !== true) return;
    const { model } = this.store.choice;
    if (model?.project) await this.reopen();
    else if (model?.exhibit) this.exhibit(model.exhibit);
    else await this.inspect(mayHold);
  }

  /** Shows the chosen file with its nets, and says that it is only a look. */
  private exhibit({ pieces }: FoldedNets): void {
    this.message.clear();
    this.store.showExhibit();
    this.progress.end(this.told.exhibit.lead(pieces.length));
  }

  /** Opens the project that is chosen, with its history. */
  private async reopen(): Promise<void> {
    const { model } = this.store.choice;
    const project = model?.project;
    if (!project) return;
    this.message.clear();
    this.progress.begin(model.name);
    const fieldsOf = (settings: Settings): FieldValues => {
      this.form.fillAll(settings);
      return this.settings.read();
    };
    const next = reopening(model, fieldsOf, () => this.door.reopen(project, { pool: this.engine }));
    const ending = await this.store.showNext(next, (pictures) => this.workshop.begin(pictures));
    if (ending.type === 'shown') await this.tellRun(ending);
    else if (ending.type !== 'nothing') this.leave(ending, model);
  }

  /** Lets a corrected model take the place of the one on the page, and tells what has become of the edits. */
  private async replace(coming: Promise<ChosenModel>): Promise<void> {
    const chosen = coming.then((each) => this.desk.replacement(each));
    const isTaken = await this.store.choose(chosen).catch((error: unknown) => this.explain(error));
    // A file that is none is not the chosen one any more when that is told.
    const { model } = this.store.choice;
    const { run } = this.store;
    if (isTaken !== true || !model || !run) return;
    this.message.clear();
    this.progress.begin(model.name);
    this.desk.begin(model, run.settings);
    const { ending, carried } = await this.store.replace((pictures) =>
      this.workshop.begin(pictures),
    );
    if (ending.type === 'nothing') return;
    if (ending.type !== 'shown') return this.leave(ending, model);
    await this.tellRun(ending);
    const [headline, ...lost] = lostWords(this.told, carried);
    if (headline !== undefined) this.message.show(headline, ...lost);
  }

  /** Unfolds what is chosen; what nobody has looked at, nor is looking at, is looked at first. */
  private async submit(): Promise<void> {
    const { check, choice, run, work } = this.store;
    const isUnfolded = run !== null && run.model.files === choice.model?.files;
    if (check || isUnfolded || work === 'running') await this.unfold();
    else await this.inspect(true);
  }

  private async inspect(mayHold: boolean): Promise<void> {
    const { model } = this.store.choice;
    if (!model) return;
    this.message.clear();
    if (this.form.isValid) this.progress.begin(model.name);
    const ending = await this.store.inspect(this.checking.ownWishes);
    if (ending.type === 'nothing') return;
    if (ending.type !== 'inspected') return this.leave(ending, model);
    const { check } = ending;
    // Edits of the result on the page would be gone with a new one.
    const isEdited = model.added !== undefined && this.store.undoable !== null;
    const holds = mayHold && (check.hasToDecide || isEdited);
    this.checking.propose(check);
    if (holds) return this.hold(check);
    if (!this.form.isValid) this.progress.end('');
    await this.unfold();
  }

  /** Shows a model before it is unfolded, and waits for the person. */
  private hold({ faces, proposal }: Check): void {
    this.store.showCheck(true);
    this.progress.end(this.told.run.hold(triangleWords(this.told, faces, proposal)));
    void this.checking.reveal();
  }

  private async unfold(): Promise<void> {
    const { model } = this.store.choice;
    const fields = this.form.read();
    if (!model || !fields) return;
    const nets = this.store.check?.nets ?? 'new';
    const asked = { ...changedSettings(fields, this.result.look), nets };
    this.message.clear();
    this.progress.begin(model.name);
    this.desk.begin(model, asked);
    const ending = await this.store.unfold(asked, this.settings.read(), (pictures) =>
      this.workshop.begin(pictures),
    );
    if (ending.type === 'shown') await this.tellRun(ending);
    // Only fewer triangles help.
    else if (ending.type === 'failed' && ending.code === tooManyFaces) await this.inspect(true);
    else if (ending.type !== 'nothing') this.leave(ending, model);
  }

  private async tellRun({ run, isWhole }: Extract<Ending, { type: 'shown' }>): Promise<void> {
    await this.result.complete();
    if (this.store.run !== run) return;
    const { hasFocus } = this.progress;
    this.progress.end(isWhole ? this.done(run) : this.told.run.stopped(leadOf(this.told, run)));
    this.form.action = this.told.run.unfoldAgain;
    if (hasFocus) this.result.focus();
  }

  /** Says why nothing came out: the result before is back, or else the pictures of the run stay with a note. */
  private leave(ending: Ending, { name }: ChosenModel): void {
    this.desk.giveUp();
    const { hasFocus } = this.progress;
    const { run } = this.store;
    const { run: told } = this.told;
    if (run) this.comeBack(run);
    else this.workshop.stop(wordsFor(told.notes, ending.type));
    if (hasFocus) this.form.focus();
    this.progress.end(wordsFor(told.farewells, ending.type));
    if (ending.type === 'empty') this.message.show(...told.nothingToUse);
    if (ending.type === 'undrawn') this.tellUndrawn(ending.run);
    if (ending.type !== 'failed') return;
    const rest = run ? [told.stillThere(run.model.name)] : [];
    const why = sentence(phraseOf(this.told, ending));
    this.message.show(told.notUnfolded(name), why, told.nextSteps[ending.cause], ...rest);
  }

  /** Another run may have used the panels of the result that is on the page. */
  private comeBack(run: FinishedRun): void {
    const { pictures, result } = run;
    if (!this.workshop.shows(pictures)) {
      this.workshop.finish(pictures, result);
      this.workshop.select(this.store.selection);
    }
    this.follower.follow(run);
  }

  /** Does what helps; what takes a new search is left to the person, in the form. */
  private mend(remedy: Remedy): void {
    const edits = remedyEdits(remedy);
    if (edits) void this.change(edits);
    else if (remedy.kind === 'finish') void this.submit();
    else if (remedy.kind === 'faces') {
      this.form.faces.set(remedy.faces);
      this.settings.reveal();
    }
  }

  /** Gives faces to the part in whose colour they were painted; that part counts from 0. */
  private async paint({ faces, part }: Painted): Promise<void> {
    const isMade = await this.change([{ kind: 'assign', faces, part: part + 1 }]);
    const { run, work } = this.store;
    if (!isMade && run && work !== 'running') this.workshop.repaint(run.result.labels);
  }

  /** Makes edits; false if nothing came of them. */
  private async change(edits: readonly DocumentEdit[]): Promise<boolean> {
    const ending = await this.edit(this.store.apply(edits), (run) => this.done(run));
    if (ending.type === 'refused') this.tellUnchanged(ending.refusal);
    return ending.type === 'shown';
  }

  /** Names a part: only texts on paper change. */
  private async rename(edit: Extract<DocumentEdit, { kind: 'name' }>): Promise<void> {
    const { text, part } = edit;
    const words = text === '' ? this.told.run.nameGone : this.told.run.named(text);
    const ending = await this.edit(this.store.apply([edit]), () => words);
    if (ending.type === 'refused')
      this.parts.refuse(part, sentence(phraseOf(this.told, ending.refusal)));
  }

  /** Changes how lines look, which is seen already; false if that cannot be done now. */
  private async restyle(look: Options): Promise<boolean> {
    const edit = { kind: 'print', options: look } as const;
    return (await this.edit(this.store.apply([edit]), () => '')).type !== 'nothing';
  }

  private async undo(): Promise<void> {
    if (!this.store.canMove || !this.store.undoable) return;
    await this.edit(this.store.undo(), (run) => this.told.run.undone(leadOf(this.told, run)));
  }

  private async redo(): Promise<void> {
    if (!this.store.canMove || !this.store.redoable) return;
    await this.edit(this.store.redo(), (run) => this.told.run.madeAgain(leadOf(this.told, run)));
  }

  private done(run: FinishedRun): string {
    return this.told.run.done(leadOf(this.told, run));
  }

  /** Follows a change of the result to its end, and tells it. */
  private async edit(change: Promise<Ending>, done: (run: FinishedRun) => string): Promise<Ending> {
    this.message.clear();
    const begin = (): void => {
      const { run, work } = this.store;
      if (run && work === 'editing')
        this.progress.begin(run.model.name, { host: this.status, isQuiet: true });
    };
    this.progress.prepare();
    const late = setTimeout(begin, editPatience);
    const ending = await change;
    clearTimeout(late);
    if (ending.type === 'nothing') return ending;
    if (ending.type === 'shown') await this.result.complete();
    // What has begun meanwhile tells its own end.
    if (this.store.work !== 'idle') return ending;
    if (this.progress.hasFocus) this.parts.focus();
    this.progress.end('');
    if (ending.type === 'shown') this.progress.end(done(ending.run));
    if (ending.type === 'cancelled') this.progress.end(this.told.run.editCancelled);
    if (ending.type === 'undrawn') this.tellUndrawn(ending.run);
    if (ending.type === 'failed') this.tellUnchanged(ending);
    return ending;
  }

  /** Draws the sheets of a run aside, and hands over what puts it on all panels. */
  private async draw(run: FinishedRun): Promise<Drawing | null> {
    const drawn = await this.result.draw(run);
    if (!drawn) return null;
    return {
      show: ({ isRenaming }) => this.show(drawn, isRenaming),
      drop: () => drawn.writer.close(),
    };
  }

  private show(drawn: DrawnRun, isRenaming: boolean): void {
    const { result, pictures } = drawn.run;
    this.result.show(drawn, isRenaming);
    if (isRenaming) this.workshop.rename(result.pieces);
    else this.workshop.finish(pictures, result);
    this.follower.follow(drawn.run);
    this.verdict.offer(drawn.run);
    this.parts.offer(result, isRenaming);
    this.edges.offer(drawn.run);
    this.pieces.offer(drawn.run);
  }

  private tellUnchanged(reason: Message): void {
    this.message.show(this.told.run.nothingChanged, sentence(phraseOf(this.told, reason)));
  }

  private tellUndrawn({ model }: FinishedRun): void {
    const { notDrawn, onceMore } = this.told.run;
    this.message.show(notDrawn(model.name), onceMore);
  }

  /** Tells a failed choice; anything else is a fault of the page and goes on as one. */
  private explain(error: unknown): void {
    if (!(error instanceof UnusableChoice)) throw error;
    this.message.show(this.told.run.nothingUnfolded, error.tell(this.told));
  }
}
