/** Entry of a worker that draws a model with the WebGL context of its canvas, or models of many with one context. */
import { newCanvas } from './context-2d.js';
import { serveDrawings } from './drawing-worker.js';
import { sharedWorkerName, type ModelAnswer, type ModelMessage } from './model-message.js';
import { ModelScene } from './model-scene.js';
import { OwnScreen, type ModelScreen } from './model-screen.js';
import { SharedRenderer } from './shared-renderer.js';
import { startWebGl } from './webgl.js';

function screenOfItsOwn(canvas: OffscreenCanvas): ModelScreen | null {
  const context = startWebGl(canvas);
  return context && new OwnScreen(canvas, context);
}

/** What makes screens that share a context. */
function sharing(): (canvas: OffscreenCanvas) => ModelScreen | null {
  const canvas = newCanvas(1, 1);
  const context = startWebGl(canvas);
  const renderer = context && new SharedRenderer(canvas, context);
  return (target) => renderer?.screenOn(target) ?? null;
}

const screenOn = self.name === sharedWorkerName ? sharing() : screenOfItsOwn;

serveDrawings<ModelMessage, ModelAnswer>((canvas, listener) => {
  const screen = screenOn(canvas);
  if (!screen) return null;
  const scene = new ModelScene(screen, listener);
  return (message) => scene.take(message);
});
