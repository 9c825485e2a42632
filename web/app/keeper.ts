import { askedProject } from '../api/asked-project.js';
import { titleOf } from '../model/model-files.js';
import type { Settings } from '../model/options.js';
import type { Project, SavedState } from '../project/project.js';
import type { FinishedRun } from './finished-run.js';
import type { ChosenModel, Kept } from './model-file.js';
import type { KeepingError, ProjectHost } from './project-host.js';
import { newId, type SaveOrder } from './shelf.js';
import type { Store } from './store.js';
import type { Portrait } from './thumbnail.js';

/** Ms after a change before it is saved: those that come quickly are saved together, and all within a second. */
const pause = 300;

/** A project that this page writes, and what of it is on the shelf already. */
interface Entry {
  kept: Kept;
  hasFiles: boolean;
  /** Keys of the states that are there. */
  keys: Map<SavedState, string>;
  /** Of the picture that is there. */
  labels: Int32Array | null;
  /** Whether a person has changed anything since the run. */
  isEdited: boolean;
}

/** What a person must be told. */
export interface KeeperListener {
  /** Another page has changed the same project: this one goes on as a copy of this name. */
  onCopy(name: string): void;
  /** Another page has deleted it for good: nothing of it is kept any more, unless `keep` is called. */
  onGone(name: string, keep: () => void): void;
  /** A change could not be saved. Not told again before one was. */
  onFault(error: KeepingError): void;
}

function newEntry(name: string): Entry {
  const kept = { id: newId(), name, revision: 0 };
  return { kept, hasFiles: false, keys: new Map(), labels: null, isEdited: false };
}

/** The name without its number, and with the next one. */
export function nextName(name: string): string {
  const [, stem = name, number = '1'] = /^(.*) \((\d+)\)$/.exec(name) ?? [];
  return `${stem} (${Number(number) + 1})`;
}

/** Whether a project is on the shelf with the result that is on the page. */
function isKeptWhole({ kept, project }: ChosenModel): boolean {
  if (!kept || !project) return false;
  const { cursor, states } = project.project;
  return states[cursor] !== null;
}

/**
 * Saves the document on the page by itself. Two pages may have the same project open: whoever saves without having
 * seen the last change goes on with a copy, so that the work of both stays, without locks that a dead page might hold.
 */
export class Keeper {
  /** Of the run on the page. */
  private present: Entry | null = null;
  /** Of the run that goes on. */
  private coming: Entry | null = null;
  /** By runs: undo may go back to the model before the one on the page. */
  private readonly entries = new WeakMap<FinishedRun['pictures'], Entry>();
  private savedRun: FinishedRun | null = null;
  /** What is to be saved: another model may come on the page meanwhile. */
  private unsaved: { entry: Entry; project: Project; run: FinishedRun } | null = null;
  /** Of the run on the page. */
  private pictures: FinishedRun['pictures'] | null = null;
  private files: ChosenModel['files'] | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private lastSave: Promise<void> = Promise.resolve();
  private isFaulty = false;

  constructor(
    private readonly store: Store,
    private readonly host: ProjectHost,
    private readonly listener: KeeperListener,
    life: AbortSignal,
  ) {
    store.on('scene', () => this.follow());
    life.addEventListener('abort', () => clearTimeout(this.timer));
  }

  /** What the project on the page is called; null while none is kept. */
  get name(): string | null {
    return this.present?.kept.name ?? null;
  }

  /** A run begins: what was asked for is kept, so that it can be asked for again. */
  begin(model: ChosenModel, settings: Settings): void {
    this.giveUp();
    const entry = newEntry(model.kept?.name ?? titleOf(model.name));
    this.coming = entry;
    const project = askedProject(model, settings);
    this.queue(() => this.write(entry, project, { isPending: true, run: null }));
  }

  /** The run has come to nothing that is on the page. */
  giveUp(): void {
    const { coming } = this;
    this.coming = null;
    if (coming) this.queue(() => this.host.call('remove', coming.kept.id, true));
  }

  /** Saves at once what is not saved yet. */
  flush(): void {
    this.note();
    this.saveNoted();
  }

  /** The project on the page, once all of it is saved; null while none is kept. */
  async settled(): Promise<Kept | null> {
    this.flush();
    await this.lastSave;
    const { present } = this;
    return present && present.kept.revision > 0 ? present.kept : null;
  }

  private follow(): void {
    this.note();
    if (this.unsaved) this.timer ??= setTimeout(() => this.flush(), pause);
  }

  /** Takes note of what is on the page, if that is not saved. */
  private note(): void {
    const { run, document } = this.store;
    if (!run || !document || run === this.savedRun || !isOf(document, run)) return;
    if (this.isNew(run)) {
      this.saveNoted();
      this.take(run);
    }
    const entry = this.present;
    if (entry && run !== this.savedRun) this.unsaved = { entry, project: document, run };
  }

  private saveNoted(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const { unsaved } = this;
    if (!unsaved) return;
    this.unsaved = null;
    const { entry, project, run } = unsaved;
    this.savedRun = run;
    entry.isEdited ||= project.steps.length > 0;
    this.queue(() => this.write(entry, project, { isPending: false, run }));
  }

  /** Edits leave a run its pictures. */
  private isNew({ pictures }: FinishedRun): boolean {
    return this.present === null || pictures !== this.pictures;
  }

  private take(run: FinishedRun): void {
    const { model, pictures } = run;
    const before = this.present;
    const wasUntouched = before !== null && !before.isEdited && this.files === model.files;
    // Another try with the same model takes the place of the one before, unless there is work in that.
    if (this.coming && wasUntouched)
      this.queue(() => this.host.call('remove', before.kept.id, true));
    // Who only looks at a project changes nothing.
    if (!this.coming && isKeptWhole(model)) this.savedRun = run;
    this.present = this.coming ?? this.entries.get(pictures) ?? this.opened(model);
    this.entries.set(pictures, this.present);
    this.coming = null;
    [this.pictures, this.files] = [pictures, model.files];
  }

  private opened({ kept, name, project }: ChosenModel): Entry {
    const entry = newEntry(project?.project.name || titleOf(name));
    entry.isEdited = true;
    return kept ? { ...entry, kept, hasFiles: true } : entry;
  }

  private queue(work: () => Promise<void>): void {
    this.lastSave = this.lastSave.then(work).then(
      () => {
        this.isFaulty = false;
      },
      (error: KeepingError) => {
        if (!this.isFaulty) this.listener.onFault(error);
        this.isFaulty = true;
      },
    );
  }

  /** What is on the page becomes a project of its own, if it is still the one that was deleted. */
  private keepAgain(entry: Entry): void {
    if (entry !== this.present) return;
    Object.assign(entry, { ...newEntry(entry.kept.name), isEdited: true });
    this.savedRun = null;
    this.flush();
  }

  private async write(
    entry: Entry,
    project: Project,
    how: { isPending: boolean; run: FinishedRun | null },
  ): Promise<void> {
    const { order, keys } = orderOf(entry, project, how.isPending);
    const portrait = how.run && portraitFor(entry, how.run);
    const outcome = await this.host.call('save', order, portrait);
    if (outcome.type === 'gone') {
      return this.listener.onGone(entry.kept.name, () => this.keepAgain(entry));
    }
    if (outcome.type === 'other') {
      const { name } = entry.kept;
      Object.assign(entry, { ...newEntry(nextName(name)), isEdited: entry.isEdited });
      this.listener.onCopy(entry.kept.name);
      return this.write(entry, project, how);
    }
    const labels = how.run?.result.labels ?? null;
    Object.assign(entry, { kept: outcome.kept, hasFiles: true, keys, labels });
  }
}

/** Whether a document is at the result of a run: an undo is in the document before it is on the page. */
function isOf({ states, cursor }: Project, { result }: FinishedRun): boolean {
  const state = states[cursor];
  return !state || state.hash === result.hash;
}

/** Null where the one that is there shows the same. */
function portraitFor({ labels: before }: Entry, { result }: FinishedRun): Portrait | null {
  const { labels, model } = result;
  if (before && labels.every((part, face) => part === before[face])) return null;
  const { vertices, faces } = model;
  return { vertices, faces, labels };
}

/** What is to be written, and the keys of all states then. */
function orderOf(
  { kept, hasFiles, keys: before }: Entry,
  project: Project,
  isPending: boolean,
): { order: SaveOrder; keys: Entry['keys'] } {
  const { name: _, files, states, ...rest } = project;
  const keys = new Map<SavedState, string>();
  const fresh = new Map<string, SavedState>();
  for (const state of states) {
    if (!state) continue;
    const key = before.get(state) ?? newId();
    keys.set(state, key);
    if (!before.has(state)) fresh.set(key, state);
  }
  const document = { ...rest, states: states.map((state) => state && keys.get(state)!) };
  const order = { kept, document, files: hasFiles ? null : files, states: fresh, isPending };
  return { order: { ...order, picture: null }, keys };
}
