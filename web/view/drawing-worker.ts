import type { CanvasMessage, Drawer } from './drawing.js';

/**
 * A worker's side of a drawing: gets the canvas, says whether it can draw on it, and from then on
 * gets what to draw, and answers what it is asked.
 *
 * @param make gives null where nothing can be drawn on such a canvas
 */
export function serveDrawing<Message, Answer = never>(
  make: (canvas: OffscreenCanvas, answer: (answer: Answer) => void) => Drawer<Message> | null,
): void {
  let drawer: Drawer<Message> | null = null;
  addEventListener(
    'message',
    ({ data }: MessageEvent<OffscreenCanvas | Message | CanvasMessage>) => {
      if (!(data instanceof OffscreenCanvas)) {
        drawer?.(data);
        return;
      }
      drawer = make(data, (answer) => postMessage(answer));
      postMessage(drawer !== null);
    },
  );
}
