/** Entry of the worker that draws a flat picture. */
import { serveDrawings } from './drawing-worker.js';
import { Painter, type PictureMessage } from './painter.js';

serveDrawings<PictureMessage>((canvas) => {
  const painter = canvas && new Painter(canvas);
  return painter && ((message) => painter.take(message));
});
