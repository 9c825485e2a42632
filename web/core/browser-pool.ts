import { startModuleWorker } from '../browser/module-worker.js';
import dracoAddress from 'draco3dgltf/draco_decoder_gltf.wasm?url';
import manifoldAddress from 'manifold-3d/manifold.wasm?url';
import wasmAddress from './generated/foldwright.wasm?url';
import { poolSize } from './pool-size.js';
import { Pool } from './pool.js';
import type { Answer } from './protocol.js';
import type { Spawn } from './worker-port.js';
import type { WorkerAddresses } from './worker-addresses.js';
import workerAddress from './worker.ts?worker&url';

/** Where a host keeps the engine's files, each if not where the build put it; absolute. */
export interface EngineAddresses {
  /** The script of the workers. */
  worker?: string | URL;
  wasm?: string | URL;
  /** The decoder of Draco, which few models need. */
  draco?: string | URL;
  /** The library that unites bodies, which is asked for by few. */
  manifold?: string | URL;
}

function workersOf({
  worker: script = workerAddress,
  wasm = wasmAddress,
  draco = dracoAddress,
  manifold = manifoldAddress,
}: EngineAddresses): Spawn {
  const addresses: WorkerAddresses = {
    wasm: String(wasm),
    draco: String(draco),
    manifold: String(manifold),
  };
  const name = JSON.stringify(addresses);
  return (listener) => {
    const worker = startModuleWorker(String(script), name);
    worker.addEventListener('message', ({ data }: MessageEvent<Answer>) => listener.onAnswer(data));
    worker.addEventListener('error', (event) => {
      listener.onDeath(event.message || 'its script could not be loaded');
    });
    return {
      post: (request, transfer) => worker.postMessage(request, transfer),
      close: () => worker.terminate(),
    };
  };
}

function defaultSize(): number {
  // Some browsers tell the memory, in GiB and at most 8.
  const { hardwareConcurrency, deviceMemory } = navigator as Navigator & { deviceMemory?: number };
  return poolSize(hardwareConcurrency, deviceMemory);
}

/** A pool of module workers of the browser; by default as many as suit the device. */
export function browserPool(size = defaultSize(), addresses: EngineAddresses = {}): Pool {
  return new Pool(workersOf(addresses), size);
}
