import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';
import { poolSize } from './pool-size.js';
import { Pool } from './pool.js';
import type { Answer } from './protocol.js';
import type { Spawn } from './worker-port.js';

/** Where a host keeps the engine's files, if not where the build put them: URLs of files. */
export interface EngineAddresses {
  /** The script of the workers. */
  worker?: URL;
  wasm?: URL;
}

/** Starts worker threads of node from a built script; the WASM lies beside it. */
export function threadsOf(script: string | URL, wasm?: string | URL): Spawn {
  return (listener) => {
    // What a dying engine prints is caught: its reason arrives as an error.
    const worker = new Worker(script, {
      stdout: true,
      stderr: true,
      ...(wasm && { workerData: { wasm: String(wasm) } }),
    });
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
export function nodePool(
  size = poolSize(availableParallelism()),
  { worker, wasm }: EngineAddresses = {},
): Pool {
  const script = worker ?? new URL('./node-worker.js', import.meta.url);
  return new Pool(threadsOf(script, wasm), size);
}
