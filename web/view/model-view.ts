import { Drawing, type DrawingFailure, type Places } from './drawing.js';
import type { ModelMessage } from './model-message.js';
import { TurnInput } from './turn-input.js';
import { startWebGl } from './webgl.js';

const places: Places<ModelMessage> = {
  worker: () => new Worker(new URL('./model-worker.ts', import.meta.url), { type: 'module' }),
  async here(canvas) {
    // Before anything is loaded for it.
    const context = startWebGl(canvas);
    if (!context) return null;
    const { ModelScene } = await import('./model-scene.js');
    const scene = new ModelScene(canvas, context);
    return (message) => scene.take(message);
  },
};

/**
 * A model in 3D that fills an element of the page, and that mouse, fingers and keys turn.
 *
 * @param onFailure is told `impossible` where there is no WebGL 2
 */
export function modelView(
  frame: HTMLElement,
  onFailure: (failure: DrawingFailure) => void,
): Drawing<ModelMessage> {
  const view = new Drawing(frame, places, onFailure);
  new TurnInput(frame, (turn) => view.tell({ type: 'turn', ...turn }));
  return view;
}
