import { watchSize, type PictureSize } from './picture-size.js';

/** Takes what there is to draw, in plain data. What is about the canvas comes to every drawer. */
export type Drawer<Message> = (message: Message | CanvasMessage) => void;

export type CanvasMessage =
  | ({ type: 'size' } & PictureSize)
  /** The last one: nobody sees the canvas any more, and what it holds can be freed. */
  | { type: 'end' };

/** Hears of a drawer. */
export interface DrawerListener<Answer> {
  answer(answer: Answer): void;
  /** It draws no more. */
  fail(error: unknown): void;
}

/** A worker that keeps to `serveDrawings`, lent to one drawing. */
export interface DrawingWorker {
  worker: Worker;
  /**
   * Whether it draws for others as well, and so sends pictures instead of drawing on the canvas: one context has one
   * canvas. Where workers copy to canvases of a page, Chromium shows nothing more once its graphics process has died.
   */
  isShared: boolean;
  /** Gives it back, to end if it draws for nobody else. May be called more than once. */
  giveBack: () => void;
}

/** Where a drawing may be made. */
export interface Places<Message, Answer = never> {
  worker: () => DrawingWorker;
  /** Makes a drawer in this thread; null where nothing can be drawn. */
  here: (
    canvas: HTMLCanvasElement,
    listener: DrawerListener<Answer>,
  ) => Promise<Drawer<Message> | null>;
}

/** What a worker gets for each drawing. */
export interface DrawingOrder {
  /** Null if pictures are to be sent. */
  canvas: OffscreenCanvas | null;
  /** Over which it hears what to draw, and sends its news. */
  port: MessagePort;
}

/** What a worker sends over the port of a drawing: first whether it can draw, later that it no longer can. */
export type DrawingNews<Answer> =
  { canDraw: boolean } | { answer: Answer } | { picture: ImageBitmap };

/** Why there is nothing to see: nobody can draw it here, or whoever could has failed. */
export type DrawingFailure = 'impossible' | 'broken';

export interface DrawingListener<Answer> {
  onFailure?(failure: DrawingFailure): void;
  onAnswer?(answer: Answer): void;
}

/**
 * Fills an element of the page with a picture that is drawn from messages: by a worker, so that the
 * page stays free, or by the page where workers cannot draw.
 */
export class Drawing<Message, Answer = never> {
  private opened = false;
  /** What was told before there was anyone to draw it. */
  private waiting: (Message | CanvasMessage)[] = [];
  private drawer: Drawer<Message> = (message) => this.waiting.push(message);
  /** Shows pictures that a worker sends. */
  private pictures: ImageBitmapRenderingContext | null = null;

  /** @param life ends whoever draws, and frees what it has of the graphics card */
  constructor(
    private readonly frame: HTMLElement,
    private readonly places: Places<Message, Answer>,
    private readonly life: AbortSignal,
    private readonly listener: DrawingListener<Answer> = {},
  ) {}

  /** Starts whoever draws, the first time that it is called. */
  async open(): Promise<void> {
    if (this.opened || this.life.aborted) return;
    this.opened = true;
    try {
      const drawer = (await this.inWorker()) ?? (await this.here());
      if (this.life.aborted) return;
      if (drawer) this.begin(drawer);
      else this.fail('impossible');
    } catch (error) {
      console.warn(error);
      this.fail('broken');
    }
  }

  /** May be called at any time: what comes too early is drawn when there is someone to draw. */
  post(message: Message): void {
    this.drawer(message);
  }

  private async inWorker(): Promise<Drawer<Message> | null> {
    const canvas = this.newCanvas();
    if (!('transferControlToOffscreen' in canvas)) return null;
    const { worker, isShared, giveBack } = this.places.worker();
    const port = order(worker, isShared ? null : canvas.transferControlToOffscreen());
    if (isShared) this.pictures = canvas.getContext('bitmaprenderer');
    const end = (): void => {
      port.postMessage({ type: 'end' });
      giveBack();
    };
    const { life } = this;
    const during = { signal: life };
    life.addEventListener('abort', end);
    if (!(await isAble(worker, port, during))) {
      end();
      return null;
    }
    worker.addEventListener('error', () => this.fail('broken'), during);
    port.addEventListener('message', ({ data }) => this.hear(data as DrawingNews<Answer>), during);
    return (message) => port.postMessage(message);
  }

  private async here(): Promise<Drawer<Message> | null> {
    const drawer = await this.places.here(this.newCanvas(), {
      answer: (answer) => this.hear({ answer }),
      fail: () => this.hear({ canDraw: false }),
    });
    const end = (): void => drawer?.({ type: 'end' });
    if (this.life.aborted) end();
    else this.life.addEventListener('abort', end);
    return drawer;
  }

  private hear(news: DrawingNews<Answer>): void {
    if ('picture' in news) this.pictures?.transferFromImageBitmap(news.picture);
    else if ('answer' in news) this.listener.onAnswer?.(news.answer);
    else if (!news.canDraw) this.fail('broken');
  }

  /** A canvas that was handed to a worker never comes back: each attempt needs one of its own. */
  private newCanvas(): HTMLCanvasElement {
    const canvas = document.createElement('canvas');
    this.frame.append(canvas);
    return canvas;
  }

  private begin(drawer: Drawer<Message>): void {
    const { waiting } = this;
    // What filled the frame until now, and attempts that failed, make room for the last one.
    for (const other of [...this.frame.children].slice(0, -1)) other.remove();
    this.drawer = drawer;
    this.waiting = [];
    waiting.forEach(drawer);
    watchSize(this.frame, this.life, (size) => this.drawer({ type: 'size', ...size }));
  }

  private fail(failure: DrawingFailure): void {
    this.waiting = [];
    this.drawer = () => undefined;
    this.listener.onFailure?.(failure);
  }
}

/** Orders a drawing of a worker; the port to whoever makes it there. */
function order(worker: Worker, canvas: OffscreenCanvas | null): MessagePort {
  const { port1, port2 } = new MessageChannel();
  const ordered: DrawingOrder = { canvas, port: port2 };
  worker.postMessage(ordered, canvas ? [canvas, port2] : [port2]);
  port1.start();
  return port1;
}

/** What a worker says first: whether it can draw. One that cannot be loaded cannot. */
function isAble(
  worker: Worker,
  port: MessagePort,
  during: { signal: AbortSignal },
): Promise<boolean> {
  return new Promise((resolve) => {
    const once = { once: true, ...during };
    const hear = ({ data }: MessageEvent<{ canDraw: boolean }>): void => resolve(data.canDraw);
    port.addEventListener('message', hear, once);
    worker.addEventListener('error', () => resolve(false), once);
  });
}
