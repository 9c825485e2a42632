import { startModuleWorker } from '../browser/module-worker.js';
import { never } from './place.js';
import type { KeepingFault, ProjectAnswer, ProjectCalls, ProjectOrder } from './project-worker.js';
import workerAddress from './project-worker.ts?worker&url';

/** A call that came to nothing. */
export class KeepingError extends Error {
  constructor(
    readonly fault: KeepingFault,
    reason: string,
  ) {
    super(reason);
  }
}

/** The worker that keeps projects and reads and writes their files; it starts with the first call. */
export class ProjectHost {
  private worker: Worker | null = null;
  /** Ends the waiting for whatever the present worker has not answered yet. */
  private end = new AbortController();

  /** @param life ends the worker, and whoever waits for it waits for ever */
  constructor(private readonly life: AbortSignal) {
    life.addEventListener('abort', () => this.worker?.terminate());
  }

  /** Rejects with a `KeepingError`. */
  call<Name extends keyof ProjectCalls>(
    name: Name,
    ...args: Parameters<ProjectCalls[Name]>
  ): ReturnType<ProjectCalls[Name]> {
    return this.ask({ name, args }) as ReturnType<ProjectCalls[Name]>;
  }

  private ask(order: ProjectOrder): Promise<unknown> {
    if (this.life.aborted) return never();
    this.worker ??= this.start();
    const { signal } = this.end;
    const { port1, port2 } = new MessageChannel();
    return new Promise((resolve, reject) => {
      const fail = (): void => reject(signal.reason as Error);
      signal.addEventListener('abort', fail, { once: true });
      port1.onmessage = ({ data }: MessageEvent<ProjectAnswer>) => {
        port1.close();
        signal.removeEventListener('abort', fail);
        if (data.type === 'done') resolve(data.value);
        else reject(new KeepingError(data.fault, data.reason));
      };
      this.worker!.postMessage(order, [port2]);
    });
  }

  private start(): Worker {
    const worker = startModuleWorker(workerAddress);
    worker.addEventListener('error', ({ message }) => {
      worker.terminate();
      this.worker = null;
      this.end.abort(new KeepingError('none', message));
      this.end = new AbortController();
    });
    return worker;
  }
}
