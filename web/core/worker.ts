/** Entry of the browser's module worker. */
import { serveEngine } from './engine-worker.js';
import createFoldwright from './generated/foldwright.mjs';
import type { Request } from './protocol.js';
import type { WorkerAddresses } from './worker-addresses.js';

const channel = new MessageChannel();

/** A message to oneself waits behind those already there, and unlike a timer for nothing else. */
function pause(): Promise<void> {
  return new Promise((resolve) => {
    channel.port1.onmessage = () => resolve();
    channel.port2.postMessage(null);
  });
}

/** The page says by the worker's name where they lie: as a module that was copied elsewhere it would not find them. */
const addresses = JSON.parse(self.name) as WorkerAddresses;

async function load(address: string): Promise<Uint8Array> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address} cannot be loaded (${answer.status})`);
  return new Uint8Array(await answer.arrayBuffer());
}

const handle = serveEngine({
  loadEngine: () => createFoldwright({ locateFile: () => addresses.wasm }),
  post: (answer, transfer) => postMessage(answer, { transfer }),
  pause,
  loadDraco: () => load(addresses.draco),
  loadManifold: () => load(addresses.manifold),
});

addEventListener('message', ({ data }: MessageEvent<Request>) => handle(data));
