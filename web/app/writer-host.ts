import { pageAssets } from '../browser/page-assets.js';
import { startModuleWorker } from '../browser/module-worker.js';
import { never } from './place.js';
import type { WriterAnswer, WriterMessage, WriterOrder, WriterSource } from './writer-worker.js';
import writerAddress from './writer-worker.ts?worker&url';

/**
 * The worker that writes the results of a studio, because thousands of faces would keep the page for too
 * long. It is started when first needed, stays, since it takes longer to start than most sheets to
 * draw, and is started anew after it has died.
 */
export class WriterHost {
  private worker: Worker | null = null;
  /** Numbers of the results that the present worker has. */
  private readonly sources = new Map<WriterSource, number>();
  private lastNumber = 0;
  /** Ends the waiting for whatever the present worker has not written yet. */
  private end = new AbortController();

  /** @param life ends the worker, and whoever waits for it waits for ever */
  constructor(private readonly life: AbortSignal) {
    life.addEventListener('abort', () => this.worker?.terminate());
  }

  /** What comes of an order; rejects if it cannot be written, or when the worker dies meanwhile. */
  order<Content>(source: WriterSource, order: WriterOrder): Promise<Content> {
    if (this.life.aborted) return never();
    this.worker ??= this.start();
    const result = this.numberOf(source, this.worker);
    const { signal } = this.end;
    const { port1, port2 } = new MessageChannel();
    const message: WriterMessage = { type: 'order', result, order };
    return new Promise<Content>((resolve, reject) => {
      const fail = (): void => reject(signal.reason as Error);
      signal.addEventListener('abort', fail, { once: true });
      port1.onmessage = ({ data }: MessageEvent<WriterAnswer<Content>>) => {
        port1.close();
        signal.removeEventListener('abort', fail);
        if (data.type === 'written') resolve(data.content);
        else reject(new Error(data.reason));
      };
      this.worker!.postMessage(message, [port2]);
    });
  }

  /** A result is not needed any more; it is sent again if it is after all. */
  forget(source: WriterSource): void {
    const result = this.sources.get(source);
    if (result === undefined) return;
    this.sources.delete(source);
    const message: WriterMessage = { type: 'forget', result };
    this.worker?.postMessage(message);
  }

  private numberOf(source: WriterSource, worker: Worker): number {
    const known = this.sources.get(source);
    if (known !== undefined) return known;
    const result = ++this.lastNumber;
    const message: WriterMessage = { type: 'result', result, source };
    worker.postMessage(message);
    this.sources.set(source, result);
    return result;
  }

  private start(): Worker {
    const worker = startModuleWorker(writerAddress);
    worker.addEventListener('error', ({ message }) => {
      worker.terminate();
      this.worker = null;
      this.sources.clear();
      this.end.abort(new Error(message));
      this.end = new AbortController();
    });
    const message: WriterMessage = { type: 'begin', assets: pageAssets };
    worker.postMessage(message);
    return worker;
  }
}
