/** How a run begins: with nets of its own, or with those that the file brings along. */
import { JobError } from '../core/job-error.js';
import type { TimedResult } from '../core/client.js';
import type { FileNets } from '../model/file-nets.js';
import type { JobStart } from '../model/job.js';
import type { JobOptions } from '../model/job-options.js';
import { keptNets, type KeptNets } from '../model/kept-nets.js';
import { sizings, type Settings } from '../model/options.js';
import type { Message } from '../model/message.js';
import type { Code, Messages } from '../words/messages.js';
import { jobOf, type Wishes } from './document-state.js';
import { inspectModel } from './inspect.js';
import type { OpenedModel } from './opened-model.js';
import type { WorkOptions } from './work.js';

/** The first job of a document. */
export interface Beginning {
  /** As they are after it: with the flaps and the size of the file. */
  wishes: Wishes;
  run: (work: WorkOptions) => Promise<TimedResult>;
}

function message<Name extends Code>(
  code: Name,
  params: Messages[Name] & Message['params'],
): Message {
  return { code, params };
}

/** Whether all pieces fit on the paper at the size that they have in the file. */
function doFit({ pieces }: FileNets, { paper, margin }: Settings): boolean {
  const [short, long] = [paper.width, paper.height].map((side) => side - 2 * margin);
  return pieces.every((sides) => Math.min(...sides) <= short! && Math.max(...sides) <= long!);
}

/** With the size of the file, where nobody asks for another one and the paper has room for it. */
function sized(settings: Settings, nets: FileNets): Settings {
  const isAsked = sizings.some((name) => settings[name] !== 'none');
  if (isAsked || !doFit(nets, settings)) return settings;
  return { ...settings, scale: nets.scale, unit: 'mm' };
}

function startOf({ labels }: KeptNets): JobStart {
  return { labels, nets: [], netEdits: [], partEdits: [], paper: null };
}

/** Runs jobs of a model, with what is to be told of its nets. */
class Jobs {
  constructor(private readonly opened: OpenedModel) {}

  async run(
    options: JobOptions,
    notices: readonly Message[],
    work: WorkOptions & { start?: JobStart },
  ): Promise<TimedResult> {
    const result = await this.opened.run(options, work);
    return { ...result, notices: [...notices, ...result.notices] };
  }

  /** @param nets that are not used */
  anew(wishes: Wishes, nets: FileNets | null): Beginning {
    return {
      wishes,
      run: (work) => {
        const unused = nets && message('file-nets-unused', { pieces: nets.pieces.length });
        return this.run(jobOf(wishes), unused ? [unused] : [], work);
      },
    };
  }

  /** New nets after all. */
  withoutNets(wishes: Wishes, what: Messages['file-nets-lost']['what']): Beginning {
    const told = message('file-nets-lost', { what });
    return { wishes, run: (work) => this.run(jobOf(wishes), [told], work) };
  }

  /**
   * Nets end at the locked edges only in the job that makes them: whoever edits them later finds no locks. The search
   * within these finds the nets of the file, and how they fold.
   */
  kept(wishes: Wishes, kept: KeptNets, isSized: boolean): Beginning {
    const size = isSized ? 'file' : 'other';
    const { count, uncut, locks } = kept;
    const told = message('file-nets-kept', { pieces: count, uncut, size });
    const job = { ...jobOf(wishes), locks };
    return { wishes, run: (work) => this.run(job, [told], { ...work, start: startOf(kept) }) };
  }
}

/** The engine does not take nets that run through flat faces; new ones then. */
function orElse(first: Beginning, second: Beginning): Beginning {
  const run = async (work: WorkOptions): Promise<TimedResult> => {
    try {
      return await first.run(work);
    } catch (error) {
      if (!(error instanceof JobError) || error.code !== 'bad-start') throw error;
      return second.run(work);
    }
  };
  return { ...first, run };
}

/**
 * Looks whether the nets of the file are wanted and can be kept.
 *
 * Rejects as a run does, where the model has to be read for that.
 */
export async function beginningOf(
  opened: OpenedModel,
  wishes: Wishes,
  { signal }: WorkOptions,
): Promise<Beginning> {
  const { settings } = wishes;
  const jobs = new Jobs(opened);
  const nets = await opened.fileNets(signal);
  if (settings.nets === 'new') return jobs.anew(wishes, nets);
  if (!nets) return jobs.withoutNets(wishes, 'none');
  if (settings.faces !== 'off') return jobs.withoutNets(wishes, 'simplified');
  const { model } = await inspectModel(opened, jobOf(wishes), signal);
  const kept = keptNets(nets, model, settings.up === 'guess' ? 'y' : settings.up);
  if (!kept) return jobs.withoutNets(wishes, 'repaired');
  const ownSize = sized(settings, nets);
  const flapEdges = settings.flaps === 'none' ? [] : kept.flapEdges;
  const first = jobs.kept({ ...wishes, settings: ownSize, flapEdges }, kept, ownSize !== settings);
  return orElse(first, jobs.withoutNets(wishes, 'flat'));
}
