/** Reads models that the engine cannot read by itself, in a worker. */
import type { ModelFiles } from '../model/model-files.js';
import { needsReader } from '../read/format.js';
import { loaded } from '../read/loading.js';
import type { ReaderTools, ReadModel } from '../read/read-model.js';
import { Unreadable } from '../read/unreadable.js';
import { engineDied, JobError } from './job-error.js';
import type { Pool } from './pool.js';
import type { Answer, ReadAnswer, ReadRequest } from './protocol.js';

/** In the worker: what comes of a request. Failures of the reader itself reject. */
export async function answerOf(
  { job, files }: ReadRequest,
  tools: ReaderTools,
): Promise<ReadAnswer> {
  try {
    const { readFiles } = await loaded(() => import('../read/read-files.js'));
    return { type: 'read', job, model: await readFiles(files, tools), failure: null };
  } catch (error) {
    if (!(error instanceof Unreadable)) throw error;
    const { code, params } = error;
    return { type: 'read', job, model: null, failure: { code, params } };
  }
}

let lastNumber = 0;

/** Asks one worker, which is thrown away if the signal does not let it finish. */
function ask(
  pool: Pool,
  worker: number,
  files: ModelFiles,
  signal: AbortSignal | undefined,
): Promise<ReadModel> {
  const job = --lastNumber;
  return new Promise<ReadModel>((resolve, reject) => {
    const cancel = (): void => {
      pool.discard(worker);
      reject(signal?.reason as Error);
    };
    const settle = (last: () => void): void => {
      signal?.removeEventListener('abort', cancel);
      last();
    };
    const fail = (reason: string): void =>
      settle(() => reject(new JobError(engineDied, { reason })));
    pool.listen({
      onAnswer(from: number, answer: Answer) {
        if (from !== worker || answer.type !== 'read' || answer.job !== job) return;
        const { model, failure } = answer;
        settle(() =>
          model ? resolve(model) : reject(new JobError(failure!.code, failure!.params)),
        );
      },
      onDeath(dead, reason) {
        if (dead === worker) fail(reason);
      },
      onClose: () => fail('its workers were closed'),
    });
    signal?.addEventListener('abort', cancel);
    pool.post(worker, { type: 'read', job, files });
  });
}

/**
 * The model in files that need a reader, read by one of the pool's workers; null for files that the engine reads
 * by itself. Identical for the same files wherever it runs.
 *
 * Rejects with a `JobError` for files that give no model, and with the signal's reason at once after an abort.
 */
export async function readModel(
  pool: () => Pool,
  files: ModelFiles,
  signal?: AbortSignal,
): Promise<ReadModel | null> {
  if (!needsReader(files)) return null;
  const workers = pool();
  return workers.inTurn(async () => {
    signal?.throwIfAborted();
    return ask(workers, workers.workers[0] ?? workers.start(), files, signal);
  });
}
