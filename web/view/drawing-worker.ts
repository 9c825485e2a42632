import type {
  CanvasMessage,
  Drawer,
  DrawerListener,
  DrawingNews,
  DrawingOrder,
} from './drawing.js';

/** Makes a drawer on a canvas; null where nothing can be drawn on it. */
export type MakeDrawer<Message, Answer> = (
  canvas: OffscreenCanvas,
  listener: DrawerListener<Answer>,
) => Drawer<Message> | null;

/**
 * A worker's side of drawings, of which it may be given several: gets a canvas and a port for each, says whether it can
 * draw there, and from then on gets what to draw, and answers what it is asked.
 */
export function serveDrawings<Message extends { type: string }, Answer = never>(
  make: MakeDrawer<Message, Answer>,
): void {
  addEventListener('message', ({ data }: MessageEvent<DrawingOrder>) => serve(data, make));
}

function serve<Message extends { type: string }, Answer>(
  { canvas, port }: DrawingOrder,
  make: MakeDrawer<Message, Answer>,
): void {
  const tell = (news: DrawingNews<Answer>): void => port.postMessage(news);
  const drawer = make(canvas, {
    answer: (answer) => tell({ answer }),
    fail: (error) => {
      console.error(error);
      tell({ canDraw: false });
    },
  });
  tell({ canDraw: drawer !== null });
  port.addEventListener('message', ({ data }: MessageEvent<Message | CanvasMessage>) => {
    drawer?.(data);
    if (data.type === 'end') port.close();
  });
  port.start();
}
