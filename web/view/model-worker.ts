/** Entry of the worker that draws a model. */
import { serveDrawing } from './drawing-worker.js';
import type { ModelMessage } from './model-message.js';
import { ModelScene } from './model-scene.js';
import { startWebGl } from './webgl.js';

serveDrawing<ModelMessage>((canvas) => {
  const context = startWebGl(canvas);
  if (!context) return null;
  const scene = new ModelScene(canvas, context);
  return (message) => scene.take(message);
});
