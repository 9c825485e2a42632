import { Conductor } from './conductor.js';
import type { Engine, WorkerHost } from './engine.js';
import { Helper } from './helper.js';
import { answerOf } from './model-reader.js';
import type { EndRequest, ReadRequest, Request, RunRequest, TaskRequest } from './protocol.js';
import { buffersOf } from './transfer.js';

/** This worker's part in a job; it has one at a time. */
class EngineWorker {
  private conductor: Conductor | null = null;
  private helper: Helper | null = null;
  private canUnite = false;
  /** What has to be loaded before anything else is done. */
  private loading: Promise<boolean> = Promise.resolve(true);

  constructor(
    private readonly engine: Engine,
    private readonly host: WorkerHost,
  ) {}

  /** Resolves when all that the request asks for is done; rejects if the engine fails. */
  async handle(request: Request): Promise<void> {
    // Requests keep their order, also those that come while something is loaded.
    await this.loading;
    if (request.type === 'run') await this.conduct(request);
    else if (request.type === 'read') await this.read(request);
    else if (request.type === 'task') await this.help(request);
    else if (request.type === 'end') await this.end(request);
    else if (this.conductor?.number === request.job) this.conductor.take(request);
  }

  private async conduct(request: RunRequest): Promise<void> {
    if (request.options.unite && !this.canUnite) {
      const loading = this.loadUniter();
      this.loading = loading;
      if (!(await loading)) return this.refuse(request);
    }
    this.conductor = new Conductor(this.engine, this.host, request);
    await this.conductor.run();
  }

  /** Loads what unites bodies; false where that fails, as without a network. */
  private async loadUniter(): Promise<boolean> {
    try {
      const { makeUniter } = await import('./solid-uniter.js');
      this.engine.setUniter(await makeUniter(await this.host.loadManifold()));
      this.canUnite = true;
    } catch {
      return false;
    }
    return true;
  }

  private refuse({ job }: RunRequest): void {
    const events = [{ type: 'error', code: 'uniter-not-loaded', params: {} } as const];
    this.host.post({ type: 'events', job, events }, []);
  }

  private async read(request: ReadRequest): Promise<void> {
    const answer = await answerOf(request, this.host);
    this.host.post(answer, buffersOf(answer));
  }

  private async help({ job, order }: TaskRequest): Promise<void> {
    if (this.helper?.number !== job) this.helper = new Helper(this.engine, this.host, job);
    await this.helper.run(order);
  }

  private async end({ job }: EndRequest): Promise<void> {
    for (const part of [this.conductor, this.helper]) {
      if (part?.number === job) await part.end();
    }
    this.host.post({ type: 'ended', job }, []);
  }
}

/**
 * Answers requests with the engine of this worker; give it every message that arrives. Whatever
 * throws in here leaves the engine in an unknown state and so ends the worker with an uncaught
 * error, which is how the other side learns of it.
 */
export function serveEngine(host: WorkerHost): (request: Request) => void {
  const worker = host.loadEngine().then((engine) => new EngineWorker(engine, host));
  const fail = (error: unknown): void => {
    // A rejected promise alone does not reach the owner of a browser's worker.
    queueMicrotask(() => {
      throw error;
    });
  };
  // An engine that cannot be loaded is told of at once, not at the first request.
  worker.catch(fail);
  return (request) => {
    void worker.then(
      (ready) => ready.handle(request).catch(fail),
      () => undefined,
    );
  };
}
