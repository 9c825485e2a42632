import type { JobOptions, JobResult } from '../model/job.js';
import type { StageSeconds } from '../model/stage-seconds.js';
import { engineDied, JobError } from './job-error.js';
import type { TimedEvent } from './protocol.js';
import type { Transport } from './transport.js';

export interface RunOptions {
  /** Ends the job; the promise then rejects with the signal's reason. */
  signal?: AbortSignal;
  /** Hears everything that the job tells, the last event included. */
  onEvent?: (event: TimedEvent) => void;
}

/** A result together with how long each stage took. */
export interface TimedResult extends JobResult {
  seconds: StageSeconds;
}

/** A worker that has not answered a cancel by then is in a long step, and replaced. */
const patience = 150;

let lastJob = 0;

function runNow(
  transport: Transport,
  bytes: Uint8Array,
  fileName: string,
  options: JobOptions,
  { signal, onEvent }: RunOptions,
): Promise<TimedResult> {
  const job = ++lastJob;
  return new Promise((resolve, reject) => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const settle = (): void => {
      clearTimeout(timer);
      signal?.removeEventListener('abort', cancel);
    };
    const fail = (reason: Error): void => {
      settle();
      reject(reason);
    };
    const aborted = (): Error => signal?.reason as Error;
    const hear = (event: TimedEvent): void => {
      const isLast = event.type === 'done' || event.type === 'error';
      if (signal?.aborted) {
        // The job ended before the cancel arrived, which is then never answered.
        if (isLast) fail(aborted());
        return;
      }
      onEvent?.(event);
      if (event.type === 'error') fail(new JobError(event.code, event.text));
      if (event.type !== 'done') return;
      settle();
      resolve({ ...event.result, seconds: event.seconds });
    };
    const port = transport.open({
      onAnswer(answer) {
        if (answer.job !== job) return;
        if (answer.type === 'cancelled') fail(aborted());
        else hear(answer.event);
      },
      onDeath(reason) {
        fail(new JobError(engineDied, `The engine stopped unexpectedly: ${reason}`));
      },
    });
    function cancel(): void {
      port.post({ type: 'cancel', job });
      timer = setTimeout(() => {
        transport.close();
        fail(aborted());
      }, patience);
    }
    signal?.addEventListener('abort', cancel);
    port.post({ type: 'run', job, bytes, fileName, options });
  });
}

/**
 * Runs one job to its end in the transport's worker, after the jobs that were given to it before.
 * The ending of `fileName` tells the format; `bytes` are copied.
 *
 * Rejects with a `JobError` when the job or its worker fails, and with the signal's reason within
 * 150 ms of an abort. Neither leaves the transport unusable.
 */
export function runJob(
  transport: Transport,
  bytes: Uint8Array,
  fileName: string,
  options: JobOptions,
  runOptions: RunOptions = {},
): Promise<TimedResult> {
  return transport.inTurn(async () => {
    runOptions.signal?.throwIfAborted();
    return runNow(transport, bytes, fileName, options, runOptions);
  });
}
