import { runJob, type TimedResult } from '../core/client.js';
import { blamesOptions, engineDied, JobError } from '../core/job-error.js';
import type { TimedEvent } from '../core/protocol.js';
import type { Pool } from '../core/pool.js';
import type { JobOptions, JobStart } from '../model/job.js';
import type { ModelFile } from './model-file.js';
import { never } from './place.js';

/** How a run ended. */
export type Outcome =
  | { type: 'done'; result: TimedResult }
  /** `best`: the nets found so far, if any. */
  | { type: 'cancelled'; best: TimedResult | null }
  | Failure;

/** `cause`: the file holds no model that can be read, or the model or the settings are at fault, or the engine is. */
export interface Failure {
  type: 'failed';
  text: string;
  cause: 'file' | 'job' | 'crash';
}

function failure(error: JobError, wasRead: boolean): Failure {
  const { code, message: text } = error;
  if (code === engineDied) return { type: 'failed', text, cause: 'crash' };
  const cause = wasRead || blamesOptions(error) ? 'job' : 'file';
  return { type: 'failed', text, cause };
}

/** Runs one job at a time in the engine's workers; a new one ends the one before. */
export class JobRunner {
  private abort: AbortController | null = null;

  /**
   * @param engine gives the workers
   * @param life ends the running job; whoever waits for that one waits for ever
   * @param onEvent hears all that jobs tell
   */
  constructor(
    private readonly engine: () => Pool,
    private readonly life: AbortSignal,
    private readonly onEvent: (event: TimedEvent) => void,
  ) {
    life.addEventListener('abort', () => this.cancel());
  }

  get running(): boolean {
    return this.abort !== null;
  }

  /** Ends the running job, if there is one. */
  cancel(): void {
    this.abort?.abort();
  }

  /** Runs a job to its end, if there is a `start` from an earlier result; never rejects. */
  async run(
    model: ModelFile,
    options: JobOptions,
    onEvent: (event: TimedEvent) => void,
    start?: JobStart,
  ): Promise<Outcome> {
    const outcome = this.life.aborted ? never() : await this.runNow(model, options, onEvent, start);
    return this.life.aborted ? never() : outcome;
  }

  private async runNow(
    model: ModelFile,
    options: JobOptions,
    onEvent: (event: TimedEvent) => void,
    start?: JobStart,
  ): Promise<Outcome> {
    this.cancel();
    const abort = new AbortController();
    this.abort = abort;
    const { signal } = abort;
    let best: TimedResult | null = null;
    let wasRead = false;
    const hear = (event: TimedEvent): void => {
      if (this.life.aborted) return;
      this.onEvent(event);
      wasRead ||= event.type === 'model';
      if (!signal.aborted) onEvent(event);
      if (event.type !== 'cancelled' || !event.best) return;
      best = { ...event.best, seconds: event.seconds };
    };
    try {
      const run = { signal, onEvent: hear, pictures: true, ...(start && { start }) };
      const result = await runJob(this.engine(), model.bytes, model.name, options, run);
      return { type: 'done', result };
    } catch (error) {
      if (signal.aborted) return { type: 'cancelled', best };
      if (!(error instanceof JobError)) throw error;
      return failure(error, wasRead);
    } finally {
      if (this.abort === abort) this.abort = null;
    }
  }
}
