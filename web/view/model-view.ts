import { Drawing, type DrawingFailure, type Places } from './drawing.js';
import type { ModelAnswer, ModelMessage } from './model-message.js';
import { TurnInput } from './turn-input.js';
import { startWebGl } from './webgl.js';

const places: Places<ModelMessage, ModelAnswer> = {
  worker: () => new Worker(new URL('./model-worker.ts', import.meta.url), { type: 'module' }),
  async here(canvas, answer) {
    // Before anything is loaded for it.
    const context = startWebGl(canvas);
    if (!context) return null;
    const { ModelScene } = await import('./model-scene.js');
    const scene = new ModelScene(canvas, context, answer);
    return (message) => scene.take(message);
  },
};

/**
 * A model in 3D that fills an element of the page, and that mouse, fingers and keys turn.
 *
 * @param onFailure is told `impossible` where there is no WebGL 2
 * @param onPick is told the part that was clicked
 */
export function modelView(
  frame: HTMLElement,
  onFailure: (failure: DrawingFailure) => void,
  onPick: (part: number) => void,
): Drawing<ModelMessage, ModelAnswer> {
  const view = new Drawing(frame, places, onFailure, ({ part }) => onPick(part));
  new TurnInput(
    frame,
    (turn) => view.tell({ type: 'turn', ...turn }),
    (x, y) => view.tell({ type: 'point', x, y }),
  );
  return view;
}
