/** Results of the built engine, for tests of what is made of them. */
import { runJob } from '../../web/core/client.js';
import { defaultOptions } from '../../web/model/default-options.js';
import type { JobResult } from '../../web/model/job.js';
import type { JobOptions } from '../../web/model/job-options.js';
import { withThreads } from './thread-pool.js';

/** A result of which how the model looks is of no interest. */
export function withoutLooks<Result extends { looks?: unknown }>(
  result: Result,
): Omit<Result, 'looks'> {
  const { looks, ...rest } = result;
  return looks ? rest : result;
}

/** Unfolds a model, given as the text of an OBJ file. */
export function engineResult(text: string, options: Partial<JobOptions> = {}): Promise<JobResult> {
  const bytes = new TextEncoder().encode(text);
  return withThreads(1, async (pool) => {
    const files = [{ name: 'model.obj', bytes }];
    return withoutLooks(await runJob(pool, files, { ...defaultOptions, ...options }));
  });
}
