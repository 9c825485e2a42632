import type { MainModule } from './generated/foldwright.mjs';
import type { ReaderTools } from '../read/read-model.js';
import type { Answer } from './protocol.js';

/** What a worker needs of the engine's module. Its jobs never throw: failures come as events. */
export type Engine = Pick<MainModule, 'createJob' | 'createSurface' | 'createTask' | 'setUniter'>;

/** What a worker differs in between browsers and node. */
export interface WorkerHost extends ReaderTools {
  loadEngine(): Promise<Engine>;
  /** Gets the WASM of the library that unites bodies. */
  loadManifold(): Promise<Uint8Array>;
  post(answer: Answer, transfer: ArrayBuffer[]): void;
  /** Resolves after the messages that are waiting have been delivered. */
  pause(): Promise<void>;
}
