/** Entry of the worker that draws a model. */
import { serveDrawing } from './drawing-worker.js';
import type { ModelMessage } from './model-message.js';
import { ModelScene } from './model-scene.js';

/** Some browsers have canvases in workers, but no WebGL for them. */
function hasWebGl(): boolean {
  const context = new OffscreenCanvas(1, 1).getContext('webgl2');
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}

serveDrawing<ModelMessage>(hasWebGl(), (canvas) => {
  const scene = new ModelScene(canvas);
  return (message) => scene.take(message);
});
