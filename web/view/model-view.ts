import { startModuleWorker } from '../browser/module-worker.js';
import { Drawing, type DrawingFailure, type Places } from './drawing.js';
import type { ModelAnswer, ModelMessage, Painted } from './model-message.js';
import modelWorker from './model-worker.ts?worker&url';
import { TurnInput } from './turn-input.js';
import { startWebGl } from './webgl.js';

const places: Places<ModelMessage, ModelAnswer> = {
  worker: () => startModuleWorker(modelWorker),
  async here(canvas, answer) {
    // Before anything is loaded for it.
    const context = startWebGl(canvas);
    if (!context) return null;
    const { ModelScene } = await import('./model-scene.js');
    const scene = new ModelScene(canvas, context, answer);
    return (message) => scene.take(message);
  },
};

export interface ModelViewListener {
  /** `impossible` where there is no WebGL 2. */
  onFailure(failure: DrawingFailure): void;
  /** The part that was clicked. */
  onPick(part: number): void;
  /** Whether hands paint. */
  isPainting(): boolean;
  /** What they have painted, which is shown so until the faces are coloured anew. */
  onPaint(painted: Painted): void;
}

/**
 * A model in 3D that fills an element of the page, and that mouse, fingers and keys turn.
 *
 * @param life ends it
 */
export function modelView(
  frame: HTMLElement,
  life: AbortSignal,
  listener: ModelViewListener,
): Drawing<ModelMessage, ModelAnswer> {
  const view = new Drawing(frame, places, life, {
    onFailure: (failure) => listener.onFailure(failure),
    onAnswer: ({ part, faces }) => {
      if (faces) listener.onPaint({ part, faces });
      else listener.onPick(part);
    },
  });
  new TurnInput(frame, {
    turn: (turn) => view.post({ type: 'turn', ...turn }),
    point: (x, y) => view.post({ type: 'point', x, y }),
    stroke: (stroke) => view.post({ type: 'stroke', ...stroke }),
    isPainting: () => listener.isPainting(),
  });
  return view;
}
