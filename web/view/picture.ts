import { Drawing } from './drawing.js';
import { ownWorker } from './own-worker.js';
import { Painter, type PictureMessage } from './painter.js';
import pictureWorker from './picture-worker.ts?worker&url';

/** A flat picture in an element of the page, until `life` ends. A run is of use without it, too: nothing fails. */
export function openPicture(frame: HTMLElement, life: AbortSignal): Drawing<PictureMessage> {
  const picture = new Drawing<PictureMessage>(
    frame,
    {
      worker: () => ownWorker(pictureWorker),
      here: (canvas) => {
        const painter = new Painter(canvas);
        return Promise.resolve((message) => painter.take(message));
      },
    },
    life,
  );
  void picture.open();
  return picture;
}
