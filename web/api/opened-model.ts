/** A model's files as the engine gets them, and what it tells as it is told to people. */
import { runJob, type RunOptions, type TimedResult } from '../core/client.js';
import { readModel } from '../core/model-reader.js';
import type { Pool } from '../core/pool.js';
import type { TimedEvent } from '../core/protocol.js';
import type { JobResult } from '../model/job.js';
import type { JobOptions } from '../model/job-options.js';
import type { ModelFiles } from '../model/model-files.js';
import type { ReadModel } from '../read/read-model.js';

/** Fills in what the model's format says where the options leave it open. */
function filledIn(options: JobOptions, { usual }: ReadModel): JobOptions {
  const { up, unit } = options;
  return {
    ...options,
    up: up === 'guess' ? (usual.up ?? up) : up,
    unit: unit === 'guess' ? (usual.unit ?? unit) : unit,
  };
}

/** A result under the name of the file that people chose, with what is to be told of that. */
function named<Result extends JobResult>(result: Result, { name, notices }: ReadModel): Result {
  return { ...result, file: name, notices: [...notices, ...result.notices] };
}

function namedEvent(event: TimedEvent, model: ReadModel): TimedEvent {
  if (event.type === 'model') return { ...event, file: model.name };
  if (event.type === 'done') return { ...event, result: named(event.result, model) };
  if (event.type !== 'cancelled' || !event.best) return event;
  return { ...event, best: named(event.best, model) };
}

/** Reads a model's files once, and runs jobs on what they give. */
export class OpenedModel {
  private reading: Promise<ReadModel | null> | null = null;

  constructor(
    private readonly files: ModelFiles,
    private readonly pool: () => Pool,
  ) {}

  /** Rejects as `runJob` does, and with a `JobError` for files that give no model. */
  async run(options: JobOptions, work: RunOptions): Promise<TimedResult> {
    const model = await this.read(work.signal);
    const pool = this.pool();
    if (!model) return runJob(pool, this.files, options, work);
    const onEvent = (event: TimedEvent): void => work.onEvent?.(namedEvent(event, model));
    const result = await runJob(pool, [model.file], filledIn(options, model), { ...work, onEvent });
    return named(result, model);
  }

  /** Read once for all jobs; another try may succeed where one was ended. */
  private read(signal: AbortSignal | undefined): Promise<ReadModel | null> {
    this.reading ??= readModel(this.pool, this.files, signal);
    const { reading } = this;
    reading.catch(() => {
      if (this.reading === reading) this.reading = null;
    });
    return reading;
  }
}
