import { Drawing, type DrawingFailure, type Places } from './drawing.js';
import type { ModelMessage } from './model-message.js';
import { TurnInput } from './turn-input.js';

const places: Places<ModelMessage> = {
  worker: () => new Worker(new URL('./model-worker.ts', import.meta.url), { type: 'module' }),
  async here(canvas) {
    // Asked before three.js is loaded for it. The scene finds the same context again.
    if (!canvas.getContext('webgl2', { alpha: true, antialias: true })) return null;
    const { ModelScene } = await import('./model-scene.js');
    const scene = new ModelScene(canvas);
    return (message) => scene.take(message);
  },
};

/**
 * A model in 3D on a canvas of the page, which mouse, fingers and keys turn.
 *
 * @param onFailure is told `impossible` where there is no WebGL 2
 */
export function modelView(
  canvas: HTMLCanvasElement,
  onFailure: (failure: DrawingFailure) => void,
): Drawing<ModelMessage> {
  const view = new Drawing(canvas, places, onFailure);
  new TurnInput(canvas, (turn) => view.tell({ type: 'turn', ...turn }));
  return view;
}
