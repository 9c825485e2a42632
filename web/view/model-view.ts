import { Drawing, type DrawingFailure } from './drawing.js';
import { Hover } from './hover.js';
import type { ModelAnswer, ModelMessage, Painted, Pointed } from './model-message.js';
import type { ModelPlaces } from './model-places.js';
import { TurnInput } from './turn-input.js';

export interface ModelViewListener {
  /** `impossible` where there is no WebGL 2. */
  onFailure(failure: DrawingFailure): void;
  /** A face is under the mouse or was clicked; the mouse is over none any more if it is -1. */
  onPoint(pointed: Pointed): void;
  /** Whether hands paint. */
  isPainting(): boolean;
  /** What they have painted, which is shown so until the faces are coloured anew. */
  onPaint(painted: Painted): void;
}

/**
 * A model in 3D that fills an element of the page, and that mouse, fingers and keys turn.
 *
 * @param places who draws it
 * @param life ends it
 */
export function modelView(
  frame: HTMLElement,
  places: ModelPlaces,
  life: AbortSignal,
  listener: ModelViewListener,
): Drawing<ModelMessage, ModelAnswer> {
  const view = new Drawing(frame, places, life, {
    onFailure: (failure) => listener.onFailure(failure),
    onAnswer: (answer) => {
      if (answer.faces) return listener.onPaint(answer);
      if (answer.why !== 'over' || hover.answered()) listener.onPoint(answer);
    },
  });
  const hover = new Hover((x, y) => view.post({ type: 'point', x, y, why: 'over' }));
  new TurnInput(frame, {
    turn: (turn) => view.post({ type: 'turn', ...turn }),
    point: (place, why) => {
      if (why !== 'over') return void (place && view.post({ type: 'point', ...place, why }));
      if (place) hover.ask(place);
      else {
        hover.end();
        listener.onPoint({ face: -1, why });
      }
    },
    stroke: (stroke) => view.post({ type: 'stroke', ...stroke }),
    isPainting: () => listener.isPainting(),
  });
  return view;
}
