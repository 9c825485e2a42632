import { Drawing } from './drawing.js';
import { Painter, type PictureMessage } from './painter.js';

/** A flat picture on a canvas of the page. Without it a run is of use, too: nothing fails. */
export function openPicture(canvas: HTMLCanvasElement): Drawing<PictureMessage> {
  const picture = new Drawing<PictureMessage>(
    canvas,
    {
      worker: () => new Worker(new URL('./picture-worker.ts', import.meta.url), { type: 'module' }),
      here: (own) => {
        const painter = new Painter(own);
        return Promise.resolve((message) => painter.take(message));
      },
    },
    () => undefined,
  );
  void picture.open();
  return picture;
}
