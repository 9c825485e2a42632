import type { Drawer } from './drawing.js';

/**
 * A worker's side of a drawing: says first whether it is `able`, then gets the canvas, and from
 * then on what to draw on it.
 */
export function serveDrawing<Message>(
  able: boolean,
  make: (canvas: OffscreenCanvas) => Drawer<Message>,
): void {
  let drawer: Drawer<Message> | null = null;
  type Heard = Parameters<Drawer<Message>>[0] | OffscreenCanvas;
  addEventListener('message', ({ data }: MessageEvent<Heard>) => {
    if (data instanceof OffscreenCanvas) drawer = make(data);
    else drawer?.(data);
  });
  postMessage(able);
}
