import type { Answer } from './protocol.js';
import { Transport } from './transport.js';

/** A transport over a module worker of the browser. */
export function browserTransport(): Transport {
  return new Transport((listener) => {
    const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }: MessageEvent<Answer>) => listener.onAnswer(data));
    worker.addEventListener('error', (event) => {
      listener.onDeath(event.message || 'its script could not be loaded');
    });
    return {
      post: (request) => worker.postMessage(request),
      close: () => worker.terminate(),
    };
  });
}
