import { startModuleWorker } from '../browser/module-worker.js';
import { Shared } from '../browser/shared.js';
import { newCanvas, type AnyCanvas } from './context-2d.js';
import type { DrawingWorker, Places } from './drawing.js';
import type { ModelAnswer, ModelMessage } from './model-message.js';
import modelWorker from './model-worker.ts?worker&url';
import { ownWorker } from './own-worker.js';
import type { ModelScreen } from './model-screen.js';
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

/** What the page itself draws with. */
interface PageRenderer {
  canvas: AnyCanvas;
  renderer: SharedRenderer;
}

const renderers = new Shared<Promise<PageRenderer | null>>((started) => {
  void started.then(
    (page) => page?.renderer.end(),
    () => undefined,
  );
});

const workers = new Shared<Worker>((worker) => worker.terminate());

function startSharedWorker(): Worker {
  const worker = startModuleWorker(modelWorker);
  worker.addEventListener('error', () => workers.discard(worker));
  return worker;
}

function lendWorker(): DrawingWorker {
  const borrower = {};
  return {
    worker: workers.lend(borrower, startSharedWorker),
    isShared: true,
    giveBack: () => workers.giveBack(borrower),
  };
}

async function startRenderer(): Promise<PageRenderer | null> {
  const canvas = newCanvas(1, 1);
  const context = startWebGl(canvas);
  if (!context) return null;
  const { SharedRenderer } = await import('./model-scenes.js');
  return { canvas, renderer: new SharedRenderer(canvas, context) };
}

/** A screen on a canvas of the page, to which what the page's own renderer has drawn is copied. */
function copyingScreen({ canvas, renderer }: PageRenderer, target: HTMLCanvasElement): ModelScreen {
  const context = target.getContext('2d');
  return renderer.newScreen(() => {
    // Setting the size clears the canvas, too.
    [target.width, target.height] = [canvas.width, canvas.height];
    context?.drawImage(canvas, 0, 0);
  });
}

/** One worker with one WebGL context for all models of the page that are drawn there, or else one context of the page. */
export const sharedPlaces: ModelPlaces = {
  worker: lendWorker,
  async here(canvas, listener) {
    const started = renderers.lend(canvas, startRenderer);
    const page = await started.catch((error: unknown) => {
      // Whoever comes later may have more luck with the network.
      renderers.discard(started);
      throw error;
    });
    if (!page) {
      renderers.giveBack(canvas);
      return null;
    }
    const { ModelScene } = await import('./model-scenes.js');
    const scene = new ModelScene(copyingScreen(page, canvas), listener);
    return (message) => {
      scene.take(message);
      if (message.type === 'end') renderers.giveBack(canvas);
    };
  },
};
