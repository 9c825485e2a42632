import type { ExportFormat } from '../export/formats.js';
import type { Notice } from '../model/job.js';
import type { PrintOptions } from '../model/print-options.js';
import { startModuleWorker } from '../browser/module-worker.js';
import type { ExportedFile } from './exporters.js';
import { never } from './place.js';
import type { WriterAnswer, WriterInput, WriterOrder, WriterSource } from './writer-worker.js';
import writerAddress from './writer-worker.ts?worker&url';

/**
 * Writes one result, in a worker, because thousands of faces would keep the page for too long. The
 * worker is started when first needed, and anew after it has died.
 */
export class ResultWriter {
  private worker: Worker | null = null;
  /** Ends the waiting for whatever the present worker has not written yet. */
  private end = new AbortController();

  /**
   * @param options how the sheets look; may be changed between orders
   * @param life ends the worker, and whoever waits for it waits for ever
   */
  constructor(
    private readonly source: WriterSource,
    public options: PrintOptions,
    private readonly life: AbortSignal,
  ) {}

  /** One sheet, counted from 0, as SVG. */
  sheet(sheet: number): Promise<string> {
    return this.order({ type: 'sheet', sheet, options: this.options });
  }

  /** All sheets in a format: pdf, svg, fold or glb. */
  file(format: ExportFormat): Promise<ExportedFile> {
    return this.order({ type: 'file', format, options: this.options });
  }

  /** What a person should know of the sheets beside what the job told. */
  notices(): Promise<Notice[]> {
    return this.order({ type: 'notices', options: this.options });
  }

  /** Ends the worker; what was asked for and has not come is rejected. */
  close(reason = 'The writer was closed'): void {
    this.worker?.terminate();
    this.worker = null;
    this.end.abort(new Error(reason));
    this.end = new AbortController();
  }

  private order<Content>(order: WriterOrder): Promise<Content> {
    if (this.life.aborted) return never();
    this.worker ??= this.start();
    const { worker } = this;
    const { signal } = this.end;
    const { port1, port2 } = new MessageChannel();
    return new Promise<Content>((resolve, reject) => {
      signal.addEventListener('abort', () => reject(signal.reason as Error));
      port1.onmessage = ({ data }: MessageEvent<WriterAnswer<Content>>) => {
        port1.close();
        if (data.type === 'written') resolve(data.content);
        else reject(new Error(data.reason));
      };
      worker.postMessage(order, [port2]);
    });
  }

  private start(): Worker {
    const worker = startModuleWorker(writerAddress);
    worker.addEventListener('error', ({ message }) => this.close(message));
    this.life.addEventListener('abort', () => worker.terminate(), { signal: this.end.signal });
    const first: WriterInput = { type: 'input', source: this.source };
    worker.postMessage(first);
    return worker;
  }
}
