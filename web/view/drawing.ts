import { watchSize, type CanvasSize } from './canvas-size.js';

/** Takes what there is to draw, in plain data. Sizes of the canvas come to every drawer. */
export type Drawer<Message> = (message: Message | SizeMessage) => void;

export type SizeMessage = { type: 'size' } & CanvasSize;

/** Where a drawing may be made. */
export interface Places<Message> {
  /** Starts a worker that keeps to `serveDrawing`. */
  worker: () => Worker;
  /** Makes a drawer in this thread; null where that cannot be. */
  here: (canvas: HTMLCanvasElement) => Promise<Drawer<Message> | null>;
}

/** Why there is nothing to see: nobody can draw it here, or whoever could has failed. */
export type DrawingFailure = 'impossible' | 'broken';

/** The worker, once it has said that it can draw; null and ended if it cannot, or not be loaded. */
function whenAble(worker: Worker): Promise<Worker | null> {
  return new Promise((resolve) => {
    const settle = (able: boolean): void => {
      if (!able) worker.terminate();
      resolve(able ? worker : null);
    };
    const once = { once: true };
    worker.addEventListener('message', ({ data }: MessageEvent<boolean>) => settle(data), once);
    worker.addEventListener('error', () => settle(false), once);
  });
}

/**
 * A canvas that is drawn from messages: by a worker, so that the page stays free, or by the page
 * where workers cannot draw.
 */
export class Drawing<Message> {
  private opened = false;
  /** What was told before there was anyone to draw it. */
  private waiting: (Message | SizeMessage)[] = [];
  private drawer: Drawer<Message> = (message) => this.waiting.push(message);

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly places: Places<Message>,
    private readonly onFailure: (failure: DrawingFailure) => void,
  ) {}

  /** Starts whoever draws, the first time that it is called. */
  async open(): Promise<void> {
    if (this.opened) return;
    this.opened = true;
    try {
      const drawer = (await this.inWorker()) ?? (await this.places.here(this.canvas));
      if (drawer) this.begin(drawer);
      else this.fail('impossible');
    } catch (error) {
      console.warn(error);
      this.fail('broken');
    }
  }

  /** May be called at any time: what comes too early is drawn when there is someone to draw. */
  tell(message: Message): void {
    this.drawer(message);
  }

  private async inWorker(): Promise<Drawer<Message> | null> {
    if (!('transferControlToOffscreen' in this.canvas)) return null;
    const worker = await whenAble(this.places.worker());
    if (!worker) return null;
    // From here on there is no way back: the page cannot draw on the canvas any more.
    worker.addEventListener('error', () => this.fail('broken'));
    const canvas = this.canvas.transferControlToOffscreen();
    worker.postMessage(canvas, [canvas]);
    return (message) => worker.postMessage(message);
  }

  private begin(drawer: Drawer<Message>): void {
    const { waiting } = this;
    this.drawer = drawer;
    this.waiting = [];
    waiting.forEach(drawer);
    watchSize(this.canvas, (size) => this.drawer({ type: 'size', ...size }));
  }

  private fail(failure: DrawingFailure): void {
    this.waiting = [];
    this.drawer = () => undefined;
    this.onFailure(failure);
  }
}
