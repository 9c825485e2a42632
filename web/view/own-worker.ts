import { startModuleWorker } from '../browser/module-worker.js';
import type { DrawingWorker } from './drawing.js';

/** Starts a worker from a module at an absolute address that draws one drawing alone, and ends with it. */
export function ownWorker(address: string): DrawingWorker {
  const worker = startModuleWorker(address);
  return { worker, isShared: false, giveBack: () => worker.terminate() };
}
