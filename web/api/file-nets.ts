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
import type { RunWork, WorkOptions } from './work.js';

/** The first job of a document. */
export interface Beginning {
  /** As they are after it: with the flaps and the size of the file. */
  readonly wishes: Wishes;
  /** What became of the nets of the file. */
  readonly told: readonly Message[];
  run(work: RunWork): Promise<TimedResult>;
}

/** A way to begin that may turn out to be none. */
interface Way extends Beginning {
  /** Whether pieces may be cut again that are too large for the sheet. */
  mayRecut: boolean;
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

/** Jobs of a model, with what is to be told of its nets. */
class Jobs {
  constructor(private readonly opened: OpenedModel) {}

  private beginning(
    wishes: Wishes,
    told: readonly Message[],
    { options = jobOf(wishes), start }: { options?: JobOptions; start?: JobStart } = {},
  ): Beginning {
    const run = (work: RunWork): Promise<TimedResult> =>
      this.opened.run(options, { ...work, ...(start && { start }) });
    return { wishes, told, run };
  }

  /** @param nets that are not used */
  anew(wishes: Wishes, nets: FileNets | null): Beginning {
    const unused = nets && message('file-nets-unused', { pieces: nets.pieces.length });
    return this.beginning(wishes, unused ? [unused] : []);
  }

  /** New nets after all. */
  withoutNets(wishes: Wishes, what: Messages['file-nets-lost']['what']): Beginning {
    return this.beginning(wishes, [message('file-nets-lost', { what })]);
  }

  /**
   * Nets end at the locked edges only in the job that makes them: whoever edits them later finds no locks. The search
   * within these finds the nets of the file, and how they fold.
   */
  kept(wishes: Wishes, kept: KeptNets, size: Messages['file-nets-kept']['size']): Beginning {
    const { count, uncut, locks } = kept;
    const { parts } = wishes.settings;
    const told = [
      message('file-nets-kept', { pieces: count, uncut, size }),
      ...(parts === 'auto' ? [] : [message('parts-unused', { parts })]),
    ];
    const options = { ...jobOf(wishes), locks };
    return this.beginning(wishes, told, { options, start: startOf(kept) });
  }
}

/** Begins in the first of several ways that the engine takes and that keeps pieces whole, if that matters; or the last. */
class FirstPossible implements Beginning {
  private chosen: Way;

  constructor(private readonly ways: readonly Way[]) {
    this.chosen = ways[0]!;
  }

  get wishes(): Wishes {
    return this.chosen.wishes;
  }

  get told(): readonly Message[] {
    return this.chosen.told;
  }

  async run(work: RunWork): Promise<TimedResult> {
    for (const way of this.ways.slice(0, -1)) {
      this.chosen = way;
      const result = await this.tried(way, work);
      const isWhole = way.mayRecut || result?.pieces.every(({ cause }) => cause !== 'sheet');
      if (result && isWhole) return result;
    }
    this.chosen = this.ways.at(-1)!;
    return this.chosen.run(work);
  }

  /** Null where nets run through flat faces, which the engine does not take. */
  private async tried(way: Way, work: RunWork): Promise<TimedResult | null> {
    try {
      return await way.run(work);
    } catch (error) {
      if (error instanceof JobError && error.code === 'bad-start') return null;
      throw error;
    }
  }
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
  // Files with nets have y up, unless a person knows better.
  const kept = keptNets(nets, model, settings.up === 'guess' ? 'y' : settings.up);
  if (!kept) return jobs.withoutNets(wishes, 'repaired');
  const flapEdges = settings.flaps === 'none' ? [] : kept.flapEdges;
  const ownSize = sized(settings, nets);
  const atOwnSize = { ...wishes, settings: ownSize, flapEdges };
  return new FirstPossible([
    ...(ownSize === settings ? [] : [{ ...jobs.kept(atOwnSize, kept, 'file'), mayRecut: false }]),
    { ...jobs.kept({ ...wishes, flapEdges }, kept, 'other'), mayRecut: true },
    { ...jobs.withoutNets(wishes, 'flat'), mayRecut: true },
  ]);
}
