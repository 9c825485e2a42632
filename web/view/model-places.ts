import { startModuleWorker } from '../browser/module-worker.js';
import { Shared } from '../browser/shared.js';
import { newCanvas } from './context-2d.js';
import type { DrawingWorker, Places } from './drawing.js';
import { sharedWorkerName, type ModelAnswer, type ModelMessage } from './model-message.js';
import modelWorker from './model-worker.ts?worker&url';
import { ownWorker } from './own-worker.js';
import type { SharedRenderer } from './shared-renderer.js';
import { startWebGl } from './webgl.js';

/** Where models are drawn. */
export type ModelPlaces = Places<ModelMessage, ModelAnswer>;

/**
 * A worker and a WebGL context for one model alone: where software stands in for a graphics card, who copies a picture
 * has to wait for it, and so do answers about what is under the mouse.
 */
export const ownPlaces: ModelPlaces = {
  worker: () => ownWorker(modelWorker),
  async here(canvas, listener) {
    // Before anything is loaded for it.
    const context = startWebGl(canvas);
    if (!context) return null;
    const { ModelScene, OwnScreen } = await import('./model-scenes.js');
    const scene = new ModelScene(new OwnScreen(canvas, context), listener);
    return (message) => scene.take(message);
  },
};

const workers = new Shared<Worker>((worker) => worker.terminate());
const renderers = new Shared<Promise<SharedRenderer | null>>((started) => {
  void started.then((renderer) => renderer?.end());
});

function startSharedWorker(): Worker {
  const worker = startModuleWorker(modelWorker, sharedWorkerName);
  worker.addEventListener('error', () => workers.discard(worker));
  return worker;
}

function lendWorker(): DrawingWorker {
  const borrower = {};
  return {
    worker: workers.lend(borrower, startSharedWorker),
    giveBack: () => workers.giveBack(borrower),
  };
}

async function startRenderer(): Promise<SharedRenderer | null> {
  const canvas = newCanvas(1, 1);
  const context = startWebGl(canvas);
  if (!context) return null;
  const { SharedRenderer } = await import('./model-scenes.js');
  return new SharedRenderer(canvas, context);
}

/** One worker with one WebGL context for all models of the page that are drawn there; so does the page without a worker. */
export const sharedPlaces: ModelPlaces = {
  worker: lendWorker,
  async here(canvas, listener) {
    const renderer = await renderers.lend(canvas, startRenderer);
    const screen = renderer?.screenOn(canvas);
    if (!screen) {
      renderers.giveBack(canvas);
      return null;
    }
    const { ModelScene } = await import('./model-scenes.js');
    const scene = new ModelScene(screen, listener);
    return (message) => {
      scene.take(message);
      if (message.type === 'end') renderers.giveBack(canvas);
    };
  },
};
