import { Drawing } from './drawing.js';
import { Painter, type PictureMessage } from './painter.js';

/** A flat picture in an element of the page. A run is of use without it, too: nothing fails. */
export function openPicture(frame: HTMLElement): Drawing<PictureMessage> {
  const picture = new Drawing<PictureMessage>(
    frame,
    {
      worker: () => new Worker(new URL('./picture-worker.ts', import.meta.url), { type: 'module' }),
      here: (canvas) => {
        const painter = new Painter(canvas);
        return Promise.resolve((message) => painter.take(message));
      },
    },
    () => undefined,
  );
  void picture.open();
  return picture;
}
