/** Pools of real worker threads of the built engine, whose workers can be killed. */
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { threadsOf } from '../../web/core/node-pool.js';
import { Pool } from '../../web/core/pool.js';
import type { Answer } from '../../web/core/protocol.js';
import type { Spawn } from '../../web/core/worker-port.js';

const script = new URL('../../dist/cli/node-worker.js', import.meta.url);

/** `npm test` builds it first; a bare run of the tests may not have it. */
export const isEngineBuilt = existsSync(fileURLToPath(script));

/** Which workers die, in the middle of what they do: when they first tell something of it. */
export interface Killing {
  victim: 'conductor' | 'helper';
  /** How many die, one after the other; the next ones live. */
  times: number;
  /** Whether it may be fewer. */
  atMost?: boolean;
  /** Whether they may die now; by default at any time. */
  armed?: () => boolean;
}

/** Whether this is what a victim says before it dies. */
function isLastWord(answer: Answer, { victim, armed }: Killing): boolean {
  if (armed && !armed()) return false;
  if (victim === 'conductor') return answer.type === 'events';
  return answer.type === 'report' && answer.report.result === null;
}

/** Gives `work` a pool and closes it afterwards. */
export async function withThreads<Result>(
  size: number,
  work: (pool: Pool) => Promise<Result>,
  killing: Killing = { victim: 'helper', times: 0 },
): Promise<Result> {
  const spawn = threadsOf(script);
  let left = killing.times;
  const deadly: Spawn = (listener) => {
    const port = spawn({
      onAnswer(answer) {
        if (left > 0 && isLastWord(answer, killing)) {
          --left;
          // The pool is not told: the thread ends as if the system had ended it.
          port.close();
        }
        listener.onAnswer(answer);
      },
      onDeath: (reason) => listener.onDeath(reason),
    });
    return port;
  };
  const pool = new Pool(deadly, size);
  try {
    const result = await work(pool);
    if (left > 0 && !killing.atMost) throw new Error(`${left} workers that were to die have lived`);
    return result;
  } finally {
    pool.close();
  }
}
