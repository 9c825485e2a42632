/** Entry of the worker that draws a model. */
import { serveDrawing } from './drawing-worker.js';
import type { ModelAnswer, ModelMessage } from './model-message.js';
import { ModelScene } from './model-scene.js';
import { startWebGl } from './webgl.js';

serveDrawing<ModelMessage, ModelAnswer>((canvas, answer) => {
  const context = startWebGl(canvas);
  if (!context) return null;
  const scene = new ModelScene(canvas, context, answer);
  return (message) => scene.take(message);
});
