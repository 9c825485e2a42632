import type { Settings } from '../model/options.js';
import type { Message } from '../model/message.js';
import { titleOf } from '../model/model-files.js';
import { isProject } from '../project/is-project.js';
import { projectEnding } from '../project/project.js';
import { formatOfFile } from '../read/format.js';
import { phraseOf } from '../words/phrase.js';
import { Keeper } from './keeper.js';
import { UnusableChoice, type ChosenModel } from './model-file.js';
import type { Offer } from './message-panel.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { ProjectHost, type KeepingError } from './project-host.js';
import { RecentPanel } from './recent-panel.js';
import { saveFile } from './save-file.js';
import { sentence } from './sentence.js';
import type { Card } from './shelf.js';
import type { Store } from './store.js';

/** Bytes of room below which a few large models fill the device. */
const scarce = 64 * 2 ** 20;

export interface DeskListener {
  /** A person wants to go on with it. */
  open(coming: Promise<ChosenModel>): void;
  tell(headline: string, ...sentences: string[]): void;
  /** The same with a button. */
  ask(offer: Offer, headline: string, ...sentences: string[]): void;
}

/** What was read of a file. @throws UnusableChoice if it cannot be read */
function unlessFailed<Value extends object>(answer: Value | { failure: Message }): Value {
  if (!('failure' in answer)) return answer;
  const { failure } = answer;
  throw new UnusableChoice((words) => sentence(phraseOf(words, failure)));
}

/** Where projects are opened, kept and written. */
export class ProjectDesk extends Panel {
  private readonly host = new ProjectHost(this.place.life);
  private readonly recent: RecentPanel;
  private readonly button = this.find('#download-project', HTMLButtonElement);
  /** Null where the studio keeps nothing by itself. */
  private keeper: Keeper | null = null;

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly listener: DeskListener,
  ) {
    super(place);
    this.recent = new RecentPanel(place, {
      open: (card) => listener.open(this.load(card)),
      rename: ({ id }, name) => void this.change(this.host.call('rename', id, name)),
      copy: ({ id, name }) =>
        void this.change(this.host.call('copy', id, this.told.keeping.copyOf(name))),
      remove: ({ id }, isRemoved) => void this.change(this.host.call('remove', id, isRemoved)),
    });
    this.button.addEventListener('click', () => void this.download());
  }

  /** Keeps the work from now on, and shows what was kept before. */
  async keep(): Promise<void> {
    const { life } = this.place;
    const { listener } = this;
    this.keeper = new Keeper(
      this.store,
      this.host,
      {
        onCopy: (name) => this.tell(this.told.keeping.copied(name)),
        onGone: (name, keep) => {
          const { deletedElsewhere, keepIt } = this.told.keeping;
          listener.ask({ words: keepIt, act: keep }, ...deletedElsewhere(name));
        },
        onFault: ({ fault }) =>
          this.tell(fault === 'full' ? this.told.keeping.full : this.told.keeping.lost),
      },
      life,
    );
    const flush = (): void => this.keeper?.flush();
    // The last moment at which a page that is closed is still heard.
    for (const type of ['visibilitychange', 'pagehide']) {
      addEventListener(type, flush, { signal: life, capture: true });
    }
    await this.change(this.host.call('tidy'));
    const room = await this.host.call('room').catch(() => null);
    if (room !== null && room < scarce) this.recent.warn();
  }

  /** A run begins. */
  begin(model: ChosenModel, settings: Settings): void {
    this.keeper?.begin(model, settings);
  }

  /** What was begun has come to nothing. */
  giveUp(): void {
    this.keeper?.giveUp();
  }

  /**
   * A choice with the document that is in it, if it is a project, or with the nets of a FOLD file. Rejects with
   * UnusableChoice for a project without a model, and for nets that are damaged.
   */
  async unpacked(model: ChosenModel): Promise<ChosenModel> {
    if (model.project || model.exhibit) return model;
    const [only, ...others] = model.files;
    if (only && others.length === 0 && formatOfFile(only) === 'fold') {
      const { nets } = unlessFailed(await this.host.call('readNets', only));
      return nets ? { ...model, exhibit: nets } : model;
    }
    const file = model.files.find(isProject);
    if (!file) return model;
    const { read } = unlessFailed(await this.host.call('read', file));
    const { files, name } = read.project;
    return { name: name || titleOf(file.name), files, project: read };
  }

  /** A choice that is to take the place of a model. Rejects with UnusableChoice for a project, which has its own edits. */
  replacement(model: ChosenModel): ChosenModel {
    if (!model.files.some(isProject)) return model;
    throw new UnusableChoice(({ replacing }) => replacing.noProject(model.name));
  }

  /** The document on the page, saved as far as it is kept here, or else the model that is chosen; null if there is none. */
  async handOver(): Promise<ChosenModel | null> {
    const { document, choice } = this.store;
    if (!document) return choice.model;
    const kept = await this.keeper?.settled();
    const { name, files } = document;
    const work = { name, files, project: { project: document, faults: [] } };
    return kept ? { ...work, kept } : work;
  }

  private async load({ id, name }: Card): Promise<ChosenModel> {
    const found = await this.host.call('load', id).catch(() => null);
    if (!found) throw new UnusableChoice(({ keeping }) => keeping.gone(name));
    const { kept, project } = found;
    return { name: kept.name, files: project.files, kept, project: { project, faults: [] } };
  }

  /** Shows what is kept after a change of it. */
  private async change(work: Promise<unknown>): Promise<void> {
    try {
      await work;
      this.recent.show(await this.host.call('cards'));
    } catch (error) {
      if ((error as KeepingError).fault === 'full') this.tell(this.told.keeping.full);
      else this.recent.refuse();
    }
  }

  private async download(): Promise<void> {
    const { document } = this.store;
    if (!document || this.button.getAttribute('aria-busy') === 'true') return;
    this.button.setAttribute('aria-busy', 'true');
    try {
      const name = this.keeper?.name ?? document.name;
      const bytes = await this.host.call('write', { ...document, name });
      saveFile(name + projectEnding, bytes, 'application/zip');
    } catch (error) {
      console.error(error);
      this.tell([this.told.run.projectNotWritten, this.told.run.resultIsHere]);
    } finally {
      this.button.removeAttribute('aria-busy');
    }
  }

  private tell([headline, ...sentences]: readonly string[]): void {
    this.listener.tell(headline ?? '', ...sentences);
  }
}
