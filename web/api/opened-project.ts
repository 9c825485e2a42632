import { version } from '../../package.json';
import type { TimedResult } from '../core/client.js';
import { JobError } from '../core/job-error.js';
import { netKey, startAgain } from '../model/edits.js';
import type { JobStart } from '../model/job.js';
import type { Message } from '../model/message.js';
import type { Settings } from '../model/options.js';
import type { Project, ReadProject, SavedState } from '../project/project.js';
import { freshWishes, jobOf, type DocumentState } from './document-state.js';
import { beginningOf } from './file-nets.js';
import type { OpenedModel } from './opened-model.js';
import { readSettings, savedWishes } from './saved-state.js';
import type { WorkOptions } from './work.js';

function hasNetsOf({ nets }: TimedResult, { start }: SavedState): boolean {
  const keys = start.nets.map(netKey);
  return nets.length === keys.length && nets.every((net, i) => netKey(net) === keys[i]);
}

/** Makes the states of a project again. */
export class OpenedProject {
  readonly project: Project;
  /** Of its run. */
  readonly settings: Settings;
  private faults: readonly Message[];

  constructor(
    private readonly model: OpenedModel,
    { project, faults }: ReadProject,
  ) {
    const { settings, lost } = readSettings(project.options);
    this.project = project;
    this.settings = settings;
    this.faults = faults;
    if (lost.length > 0) this.tell({ code: 'project-options-lost', params: { options: lost } });
  }

  /** Something to be told with the results that come. */
  tell(fault: Message): void {
    this.faults = [...this.faults, fault];
  }

  /** The run with which it began. */
  async run(work: WorkOptions): Promise<DocumentState> {
    const beginning = await beginningOf(this.model, freshWishes(this.settings), work);
    const result = await beginning.run(work);
    const { told, wishes } = beginning;
    const notices = [...this.faults, ...told, ...result.notices];
    const start = startAgain(result, null);
    return { wishes, result: { ...result, notices }, start, isStopped: false };
  }

  /**
   * A state by the last stage alone; null if other bits come of that. Of a project of another version, whose
   * search may find other nets today, those that were saved are kept.
   */
  async restore(saved: SavedState, work: WorkOptions): Promise<DocumentState | null> {
    const wishes = savedWishes(saved);
    const { isStopped = false } = saved;
    const start: JobStart = { ...saved.start, netEdits: [], partEdits: [] };
    const result = await this.lastStage(saved, { ...work, start, searches: !isStopped });
    if (!result) return null;
    const isSame = result.hash === saved.hash;
    const isOlder = this.project.app !== version && hasNetsOf(result, saved);
    if (!isSame && !isOlder) return null;
    const redrawn: Message[] = isSame ? [] : [{ code: 'project-redrawn', params: {} }];
    const notices = [...this.faults, ...redrawn, ...saved.told.notices];
    return { wishes, result: { ...result, ...saved.told, notices }, start, isStopped };
  }

  /** Null where the engine does not take what was saved. */
  private async lastStage(
    saved: SavedState,
    work: WorkOptions & { start: JobStart; searches: boolean },
  ): Promise<TimedResult | null> {
    try {
      return await this.model.run(jobOf(savedWishes(saved)), work);
    } catch (error) {
      if (!(error instanceof JobError)) throw error;
      return null;
    }
  }
}
