import { watchSize, type PictureSize } from './picture-size.js';

/** Takes what there is to draw, in plain data. What is about the canvas comes to every drawer. */
export type Drawer<Message> = (message: Message | CanvasMessage) => void;

export type CanvasMessage =
  | ({ type: 'size' } & PictureSize)
  /** The last one: nobody sees the canvas any more, and what it holds can be freed. Workers are ended instead. */
  | { type: 'end' };

/** Where a drawing may be made. */
export interface Places<Message, Answer = never> {
  /** Starts a worker that keeps to `serveDrawing`. */
  worker: () => Worker;
  /** Makes a drawer in this thread; null where nothing can be drawn. */
  here: (
    canvas: HTMLCanvasElement,
    answer: (answer: Answer) => void,
  ) => Promise<Drawer<Message> | null>;
}

/** Why there is nothing to see: nobody can draw it here, or whoever could has failed. */
export type DrawingFailure = 'impossible' | 'broken';

/** What a worker says first: whether it can draw. One that cannot be loaded cannot. */
function isAble(worker: Worker): Promise<boolean> {
  return new Promise((resolve) => {
    const once = { once: true };
    worker.addEventListener('message', ({ data }: MessageEvent<boolean>) => resolve(data), once);
    worker.addEventListener('error', () => resolve(false), once);
  });
}

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
    const worker = this.places.worker();
    const offscreen = canvas.transferControlToOffscreen();
    this.life.addEventListener('abort', () => worker.terminate());
    worker.postMessage(offscreen, [offscreen]);
    if (!(await isAble(worker))) {
      worker.terminate();
      return null;
    }
    worker.addEventListener('error', () => this.fail('broken'));
    worker.addEventListener('message', ({ data }: MessageEvent<Answer>) => this.answer(data));
    return (message) => worker.postMessage(message);
  }

  private async here(): Promise<Drawer<Message> | null> {
    const drawer = await this.places.here(this.newCanvas(), (answer) => this.answer(answer));
    const end = (): void => drawer?.({ type: 'end' });
    if (this.life.aborted) end();
    else this.life.addEventListener('abort', end);
    return drawer;
  }

  private answer(answer: Answer): void {
    this.listener.onAnswer?.(answer);
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
