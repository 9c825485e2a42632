import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';
import { poolSize } from './pool-size.js';
import { Pool } from './pool.js';
import type { Answer } from './protocol.js';
import type { Spawn } from './worker-port.js';

/** Starts worker threads of node from a built script; the WASM lies beside it. */
export function threadsOf(script: URL): Spawn {
  return (listener) => {
    // What a dying engine prints is caught: its reason arrives as an error.
    const worker = new Worker(script, { stdout: true, stderr: true });
    worker.on('message', (answer: Answer) => listener.onAnswer(answer));
    worker.on('error', (error) => listener.onDeath(error.message));
    worker.on('exit', (status) => listener.onDeath(`its thread ended with status ${status}`));
    return {
      post: (request, transfer) => worker.postMessage(request, transfer),
      close: () => void worker.terminate(),
    };
  };
}

/**
 * A pool of worker threads of node; by default one per core, at most four. Close it, or the process
 * does not end.
 */
export function nodePool(size = poolSize(availableParallelism())): Pool {
  return new Pool(threadsOf(new URL('./node-worker.js', import.meta.url)), size);
}
