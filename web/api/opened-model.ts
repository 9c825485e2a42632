/** A model's files as the engine gets them, and what it tells as it is told to people. */
import { runJob, type RunOptions, type TimedResult } from '../core/client.js';
import { readModel } from '../core/model-reader.js';
import type { Pool } from '../core/pool.js';
import type { TimedEngineEvent } from '../core/protocol.js';
import type { FileNets } from '../model/file-nets.js';
import type { JobOptions } from '../model/job-options.js';
import type { ModelFiles } from '../model/model-files.js';
import type { ReadModel } from '../read/read-model.js';
import { FinishedResults } from './finished-results.js';
import type { RunWork } from './work.js';

/** Fills in what the model's format says where the options leave it open. */
function filledIn(options: JobOptions, { usual }: ReadModel): JobOptions {
  const { up, unit } = options;
  return {
    ...options,
    up: up === 'guess' ? (usual.up ?? up) : up,
    unit: unit === 'guess' ? (usual.unit ?? unit) : unit,
  };
}

/** Files as they were read, and what is made of the engine's results for them. */
interface Opened {
  model: ReadModel | null;
  finished: FinishedResults;
}

/** Reads a model's files once, and runs jobs on what they give. */
export class OpenedModel {
  private opening: Promise<Opened> | null = null;

  constructor(
    private readonly files: ModelFiles,
    private readonly pool: () => Pool,
  ) {}

  /** Rejects as `runJob` does, and with a `JobError` for files that give no model. */
  async run(
    options: JobOptions,
    work: RunWork & Pick<RunOptions, 'start' | 'searches'>,
  ): Promise<TimedResult> {
    const { model, finished } = await this.open(work.signal);
    const files = model ? [model.file] : this.files;
    const onEvent = (event: TimedEngineEvent): void => {
      if (!finished.isPremature(event)) work.onEvent?.(finished.ofEvent(event));
    };
    const wanted = model ? filledIn(options, model) : options;
    return finished.of(await runJob(this.pool(), files, wanted, { ...work, onEvent }));
  }

  /** Nets that the file brings along; null where it has none. Rejects as `run` does for files that give no model. */
  async fileNets(signal?: AbortSignal): Promise<FileNets | null> {
    return (await this.open(signal)).model?.nets ?? null;
  }

  /** Once for all jobs; another try may succeed where one was ended. */
  private open(signal: AbortSignal | undefined): Promise<Opened> {
    this.opening ??= this.openNow(signal);
    const { opening } = this;
    opening.catch(() => {
      if (this.opening === opening) this.opening = null;
    });
    return opening;
  }

  private async openNow(signal: AbortSignal | undefined): Promise<Opened> {
    const model = await readModel(this.pool, this.files, signal);
    return { model, finished: new FinishedResults(this.files, model) };
  }
}
