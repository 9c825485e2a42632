/** Entry of the worker thread under node; the WASM lies beside the built script. */
import { readFile } from 'node:fs/promises';
import { setImmediate } from 'node:timers/promises';
import { parentPort, workerData } from 'node:worker_threads';
import { serveEngine } from './engine-worker.js';
import createFoldwright from './generated/foldwright.mjs';
import type { Request } from './protocol.js';

const handle = serveEngine({
  loadEngine: async () => {
    const { wasm } = (workerData ?? {}) as { wasm?: string };
    const wasmBinary = await readFile(new URL(wasm ?? './foldwright.wasm', import.meta.url));
    return createFoldwright({ wasmBinary });
  },
  post: (answer, transfer) => parentPort!.postMessage(answer, transfer),
  pause: () => setImmediate(),
  loadDraco: () => readFile(new URL('./draco.wasm', import.meta.url)),
  loadManifold: () => readFile(new URL('./manifold.wasm', import.meta.url)),
});

parentPort!.on('message', (request: Request) => handle(request));
