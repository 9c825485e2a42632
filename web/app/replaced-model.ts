/** One history of two models, of which the second one has taken the place of the first one. */
import type { DocumentState } from '../api/document-state.js';
import type { Applied, Refusal } from '../api/edit-plan.js';
import type { Inspection } from '../api/inspect.js';
import type { RunWork, WorkOptions } from '../api/work.js';
import type { Options } from '../api/written-options.js';
import type { Report } from '../export/report.js';
import type { DocumentEdit } from '../model/document-edits.js';
import type { JobResult } from '../model/job.js';
import type { Settings } from '../model/options.js';
import type { Project } from '../project/project.js';
import type { OpenModel } from './store-needs.js';

/**
 * Two documents, of which undo and redo go from the one to the other in one step: the edits that the later one begins
 * with came with the replacement. What is kept and written is the document that is open.
 */
export class ReplacedModel implements OpenModel {
  private isLater = true;
  /** An edit of the earlier document leaves no way ahead. */
  private isLaterGone = false;
  /** Positions between which the replacement lies. */
  private readonly lastBefore: number;
  private readonly firstAfter: number;

  constructor(
    private readonly earlier: OpenModel,
    private readonly later: OpenModel,
  ) {
    this.lastBefore = earlier.position;
    this.firstAfter = later.position;
  }

  /** The session of the model that is open now. */
  get open(): OpenModel {
    return this.isLater ? this.later : sessionIn(this.earlier);
  }

  get settings(): Settings | null {
    return this.present.settings;
  }

  get position(): number {
    if (!this.isLater) return this.earlier.position;
    return this.lastBefore + 1 + this.later.position - this.firstAfter;
  }

  /** The replacement is no edit: it is an empty list. */
  get lastStep(): readonly DocumentEdit[] | null {
    return this.isAtBegin ? [] : this.present.lastStep;
  }

  get nextStep(): readonly DocumentEdit[] | null {
    return this.isAtEnd ? [] : this.present.nextStep;
  }

  get before(): JobResult | null {
    return this.isAtBegin ? null : this.present.before;
  }

  undo(): boolean {
    if (!this.isAtBegin) return this.present.undo();
    this.isLater = false;
    return true;
  }

  redo(): boolean {
    if (!this.isAtEnd) return this.present.redo();
    this.isLater = true;
    return true;
  }

  async apply(
    edit: DocumentEdit | readonly DocumentEdit[],
    work: RunWork = {},
  ): Promise<Applied | Refusal> {
    const made = await this.present.apply(edit, work);
    this.isLaterGone ||= made.ok && !this.isLater;
    return made;
  }

  state(work: WorkOptions = {}): Promise<DocumentState> {
    return this.present.state(work);
  }

  project(): Project {
    return this.present.project();
  }

  inspect(
    options: Pick<Options, 'faces' | 'up'> = {},
    work: Pick<WorkOptions, 'signal'> = {},
  ): Promise<Inspection> {
    return this.present.inspect(options, work);
  }

  runWith(settings: Settings, work: RunWork = {}): Promise<Report> {
    return this.present.runWith(settings, work);
  }

  private get present(): OpenModel {
    return this.isLater ? this.later : this.earlier;
  }

  private get isAtBegin(): boolean {
    return this.isLater && this.later.position <= this.firstAfter;
  }

  private get isAtEnd(): boolean {
    return !this.isLater && !this.isLaterGone && this.earlier.position === this.lastBefore;
  }
}

/** The session of one model in a history that may be of several. */
export function sessionIn(model: OpenModel): OpenModel {
  return model instanceof ReplacedModel ? model.open : model;
}
