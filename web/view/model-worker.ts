/** Entry of a worker that draws a model on a canvas, or pictures of any number of models with one WebGL context. */
import { serveDrawings } from './drawing-worker.js';
import type { ModelAnswer, ModelMessage } from './model-message.js';
import { ModelScene } from './model-scene.js';
import { OwnScreen, type ModelScreen } from './model-screen.js';
import { SharedRenderer } from './shared-renderer.js';
import { startWebGl } from './webgl.js';

/** What pictures are drawn on. */
const hidden = new OffscreenCanvas(1, 1);

/** Started with the first model of which pictures are asked for; null where there is no WebGL 2. */
let renderer: SharedRenderer | null | undefined;

function sharedRenderer(): SharedRenderer | null {
  if (renderer !== undefined) return renderer;
  const context = startWebGl(hidden);
  renderer = context && new SharedRenderer(hidden, context);
  return renderer;
}

function sharedScreen(show: (picture: ImageBitmap) => void): ModelScreen | null {
  return sharedRenderer()?.newScreen(() => show(hidden.transferToImageBitmap())) ?? null;
}

function ownScreen(canvas: OffscreenCanvas): ModelScreen | null {
  const context = startWebGl(canvas);
  return context && new OwnScreen(canvas, context);
}

serveDrawings<ModelMessage, ModelAnswer>((canvas, listener) => {
  const screen = canvas ? ownScreen(canvas) : sharedScreen((picture) => listener.show(picture));
  if (!screen) return null;
  const scene = new ModelScene(screen, listener);
  return (message) => scene.take(message);
});
