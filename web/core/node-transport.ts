import { Worker } from 'node:worker_threads';
import type { Answer } from './protocol.js';
import { Transport } from './transport.js';

/** A transport over a worker thread of node; close it, or the process does not end. */
export function nodeTransport(): Transport {
  return new Transport((listener) => {
    // What a dying engine prints is caught: its reason arrives as an error.
    const worker = new Worker(new URL('./node-worker.js', import.meta.url), {
      stdout: true,
      stderr: true,
    });
    worker.on('message', (answer: Answer) => listener.onAnswer(answer));
    worker.on('error', (error) => listener.onDeath(error.message));
    worker.on('exit', (status) => listener.onDeath(`its thread ended with status ${status}`));
    return {
      post: (request) => worker.postMessage(request),
      close: () => void worker.terminate(),
    };
  });
}
