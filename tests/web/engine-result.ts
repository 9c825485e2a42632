/** Results of the built engine, for tests of what is made of them. */
import { runJob } from '../../web/core/client.js';
import { defaultOptions } from '../../web/model/default-options.js';
import type { JobResult } from '../../web/model/job.js';
import type { JobOptions } from '../../web/model/job-options.js';
import { withThreads } from './thread-pool.js';

/** Unfolds a model, given as the text of an OBJ file. */
export function engineResult(text: string, options: Partial<JobOptions> = {}): Promise<JobResult> {
  const bytes = new TextEncoder().encode(text);
  return withThreads(1, (pool) =>
    runJob(pool, [{ name: 'model.obj', bytes }], { ...defaultOptions, ...options }),
  );
}
