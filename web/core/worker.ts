/** Entry of the browser's module worker. */
import dracoAddress from 'draco3dgltf/draco_decoder_gltf.wasm?url';
import { serveEngine } from './engine-worker.js';
import createFoldwright from './generated/foldwright.mjs';
import wasmAddress from './generated/foldwright.wasm?url';
import type { Request } from './protocol.js';

const channel = new MessageChannel();

/** A message to oneself waits behind those already there, and unlike a timer for nothing else. */
function pause(): Promise<void> {
  return new Promise((resolve) => {
    channel.port1.onmessage = () => resolve();
    channel.port2.postMessage(null);
  });
}

/** A host that keeps the WASM elsewhere says so by the worker's name. */
const { name } = self;

async function loadDraco(): Promise<Uint8Array> {
  const answer = await fetch(dracoAddress);
  if (!answer.ok) throw new Error(`the decoder of Draco cannot be loaded (${answer.status})`);
  return new Uint8Array(await answer.arrayBuffer());
}

const handle = serveEngine({
  loadEngine: () => createFoldwright({ locateFile: () => name || wasmAddress }),
  post: (answer, transfer) => postMessage(answer, { transfer }),
  pause,
  loadDraco,
});

addEventListener('message', ({ data }: MessageEvent<Request>) => handle(data));
