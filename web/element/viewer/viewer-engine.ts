/** What a viewer needs of the engine; loaded when it is first asked to unfold something. */
import { askedProject } from '../../api/asked-project.js';
import { open } from '../../api/browser.js';
import type { Session } from '../../api/session.js';
import { changedSettings, defaultSettings, type Options } from '../../api/written-options.js';
import type { TimedResult } from '../../core/client.js';
import { JobError } from '../../core/job-error.js';
import type { TimedEvent } from '../../core/protocol.js';
import type { WrittenFile } from '../../export/formats.js';
import type { Language } from '../../model/languages.js';
import { probableModel, titleOf, type ModelFiles } from '../../model/model-files.js';
import { isProject } from '../../project/is-project.js';
import { projectEnding } from '../../project/project.js';
import { writeProject } from '../../project/write-project.js';
import { BadOption } from '../../words/bad-option.js';
import { loadWords } from '../../words/load.js';
import { phraseOf } from '../../words/phrase.js';
import { lendPool } from '../engine-pool.js';
import type { Exhibit } from './exhibit.js';
import { sizeOption } from './target-size.js';

export interface UnfoldWork {
  signal: AbortSignal;
  onEvent: (event: TimedEvent) => void;
}

/** What the attributes of a viewer ask for. */
export interface Wishes {
  options: Options;
  /** As it is written: mm of the longest side of the finished model; null if it was not asked for. */
  targetSize: string | null;
}

const utf8 = new TextDecoder();

/** A model and the session that unfolds it. Viewers and studios on a page share the workers. */
export class ViewerEngine {
  private readonly loan = lendPool(() => undefined);
  private session: Session | null = null;
  /** Of the session. */
  private files: ModelFiles | null = null;

  /** The session of what was unfolded last; null before. */
  get current(): Session | null {
    return this.session;
  }

  /**
   * Unfolds a model, or takes up a project as it was saved.
   *
   * Rejects as `Session.run` does; what was unfolded before stays then.
   */
  async unfold(files: ModelFiles, wishes: Wishes, work: UnfoldWork): Promise<Exhibit> {
    const session = await this.open(files);
    // A project has its run already.
    if (!session.settings) {
      await session.run(await optionsFor(session, wishes, work.signal), work);
    }
    const result = await session.result(work);
    const exhibit = await exhibitOf(session, result, wishes.options);
    work.signal.throwIfAborted();
    this.session?.close();
    this.session = session;
    this.files = files;
    return exhibit;
  }

  /**
   * The project of a model: with its result if it is the one that was unfolded last, else with what was asked for. What
   * is a project already comes as it is. Rejects as `unfold` does.
   */
  async project(files: ModelFiles, wishes: Wishes, signal: AbortSignal): Promise<WrittenFile> {
    if (this.session && this.files === files) {
      const [file] = await this.session.export('foldwright');
      return file!;
    }
    const project = files.find(isProject);
    if (project) return { name: project.name, bytes: project.bytes };
    const options = await optionsFor(await this.open(files), wishes, signal);
    const name = titleOf(probableModel(files));
    const asked = askedProject({ name, files }, changedSettings(defaultSettings(), options));
    return { name: name + projectEnding, bytes: writeProject(asked) };
  }

  /** What a model or an option is blamed for, in a language; null for any other fault. */
  async faultIn(language: Language, error: unknown): Promise<string | null> {
    const words = await loadWords(language);
    if (error instanceof JobError) return phraseOf(words, error);
    return error instanceof BadOption ? words.optionFault(error.params) : null;
  }

  /** Gives the workers back. */
  close(): void {
    this.session?.close();
    this.session = this.files = null;
    this.loan.giveBack();
  }

  private open(files: ModelFiles): Promise<Session> {
    return open(files, { pool: () => this.loan.pool() });
  }
}

/** All that is asked for, with the size of the finished model as the engine takes it. */
async function optionsFor(
  session: Session,
  { options, targetSize }: Wishes,
  signal: AbortSignal,
): Promise<Options> {
  if (targetSize === null) return options;
  const { model } = await session.inspect({}, { signal });
  return { ...options, ...sizeOption(targetSize, model.vertices) };
}

async function exhibitOf(
  session: Session,
  result: TimedResult,
  { lang }: Options,
): Promise<Exhibit> {
  const { model, pieces, sheets } = result;
  const files = await session.export('svg', { lang });
  const nets = files
    .slice(0, sheets.length)
    .map(({ bytes }, sheet) => ({ kind: 'sheet', svg: utf8.decode(bytes), sheet }) as const);
  return { title: session.title, model, pieces, nets, sheets: sheets.length };
}
