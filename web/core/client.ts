import type { EngineResult, JobResult, JobStart } from '../model/job.js';
import type { JobOptions } from '../model/job-options.js';
import type { ModelFiles } from '../model/model-files.js';
import type { StageSeconds } from '../model/stage-seconds.js';
import { engineDied, JobError } from './job-error.js';
import { JobRun } from './job-run.js';
import type { Pool } from './pool.js';
import type { TimedEngineEvent } from './protocol.js';

export interface RunOptions {
  /** Ends the job; the promise then rejects with the signal's reason. */
  signal?: AbortSignal;
  /** Ends the job as well, but waits until the nets found so far are on sheets, which takes seconds for
   * large models; `signal` still ends the wait. */
  stop?: AbortSignal;
  /** Hears everything that the job tells, the last event included; batches come ten times a second
   * at most. After a stop it hears `cancelled` with the nets found so far. So it does after an abort,
   * unless the job was in a long step and its worker had to be replaced. */
  onEvent?: (event: TimedEngineEvent) => void;
  /** Whether `generation` events show the net under search now and then. */
  pictures?: boolean;
  /** Whether `draft` events tell what could be printed already, once every part has a net. */
  drafts?: boolean;
  /** False: no nets are searched, and the result is made of those of `start` alone, as it would be after a stop. */
  searches?: boolean;
  /** How long an aborted run waits for an answer of its workers, in ms; 80 unless given. */
  patience?: number;
  /** Changes an earlier result of the same files instead of starting afresh. The options that decide
   * the mesh must be those of that result; `parts` is not read. */
  start?: JobStart;
}

/** A result together with how long each stage took. */
export interface TimedResult extends JobResult {
  seconds: StageSeconds;
}

/** The same as the engine gives it. */
export interface TimedEngineResult extends EngineResult {
  seconds: StageSeconds;
}

/** A model's files and what to do with them. */
interface Order {
  files: ModelFiles;
  options: JobOptions;
  start: JobStart | null;
}

let lastJob = 0;

/** What a job that nobody has ended comes to, with how long it took. */
function resultOf(event: TimedEngineEvent): { result: EngineResult; seconds: StageSeconds } | null {
  if (event.type === 'done') return event;
  if (event.type !== 'cancelled' || !event.best) return null;
  return { result: event.best, seconds: event.seconds };
}

function runNow(pool: Pool, order: Order, runOptions: RunOptions): Promise<TimedEngineResult> {
  const { signal, stop, onEvent, patience } = runOptions;
  const { pictures = false, drafts = false, searches = true } = runOptions;
  return new Promise((resolve, reject) => {
    const settle = (last: () => void, waitsForNets = false): void => {
      run.end(() => {
        signal?.removeEventListener('abort', cancel);
        stop?.removeEventListener('abort', handOver);
        last();
      }, waitsForNets);
    };
    const fail = (error: Error, waitsForNets = false): void =>
      settle(() => reject(error), waitsForNets);
    const cancel = (): void => fail(signal?.reason as Error);
    const handOver = (): void => fail(stop?.reason as Error, true);
    const run = new JobRun(
      pool,
      { ...order, job: ++lastJob, pictures, drafts, searches },
      {
        onEvent(event) {
          onEvent?.(event);
          if (event.type === 'error') fail(new JobError(event.code, event.params, event.faces));
          const made = resultOf(event);
          if (made) settle(() => resolve({ ...made.result, seconds: made.seconds }));
          else if (event.type === 'cancelled' && !searches) fail(new JobError('bad-start', {}));
        },
        onDeath(reason) {
          fail(new JobError(engineDied, { reason }));
        },
      },
      patience,
    );
    signal?.addEventListener('abort', cancel);
    stop?.addEventListener('abort', handOver);
  });
}

/**
 * Runs one job to its end with the pool's workers, after the jobs that were given to it before. The
 * files' bytes are copied. The result does not depend on the number of workers, nor on whether some
 * died.
 *
 * Rejects with a `JobError` when the job or its conducting worker fails, or a task that several
 * workers died over, and with the signal's reason within `patience` of an abort, or the reason of
 * `stop`. None of that leaves the pool unusable.
 */
export function runJob(
  pool: Pool,
  files: ModelFiles,
  options: JobOptions,
  runOptions: RunOptions = {},
): Promise<TimedEngineResult> {
  return pool.inTurn(async () => {
    runOptions.signal?.throwIfAborted();
    runOptions.stop?.throwIfAborted();
    return runNow(pool, { files, options, start: runOptions.start ?? null }, runOptions);
  });
}
