import type {
  CanvasMessage,
  Drawer,
  DrawerListener,
  DrawingNews,
  DrawingOrder,
} from './drawing.js';

/** Hears of a drawer in a worker. */
export interface WorkerListener<Answer> extends DrawerListener<Answer> {
  /** Takes a picture to the page, where the order came without a canvas. */
  show(picture: ImageBitmap): void;
}

/** Makes a drawer on the canvas of an order, or of pictures; null where nothing can be drawn so. */
export type MakeDrawer<Message, Answer> = (
  canvas: OffscreenCanvas | null,
  listener: WorkerListener<Answer>,
) => Drawer<Message> | null;

/**
 * A worker's side of drawings, of which it may be given several: gets an order for each, says whether it can be done, and from
 * then on gets what to draw, and answers what it is asked.
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
  const tell = (news: DrawingNews<Answer>, transfer: Transferable[] = []): void =>
    port.postMessage(news, transfer);
  const drawer = make(canvas, {
    answer: (answer) => tell({ answer }),
    show: (picture) => tell({ picture }, [picture]),
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
