import type { Answer, Request } from './protocol.js';
import type { Port, Spawn } from './worker-port.js';

/** What the workers of a pool report to the job that has its turn. */
export interface PoolListener {
  onAnswer(worker: number, answer: Answer): void;
  /** The worker is gone; `reason` is for people. */
  onDeath(worker: number, reason: string): void;
  /** All workers were ended on purpose. */
  onClose(): void;
}

/** Long enough for a person to change an option; then the memory is worth more. In ms. */
const mostIdle = 30_000;

/**
 * Workers that stay from job to job. They are started when asked for and thrown away when they die
 * or do not answer; all but one are shut down when no job has come for a while. Jobs take turns, so
 * that a worker that must be thrown away takes only its own job with it.
 */
export class Pool {
  private readonly ports = new Map<number, Port>();
  private listener: PoolListener | null = null;
  private lastWorker = 0;
  private lastTurn: Promise<unknown> = Promise.resolve();
  private idle: ReturnType<typeof setTimeout> | undefined;

  /** @param size the most workers at a time */
  constructor(
    private readonly spawn: Spawn,
    readonly size: number,
  ) {}

  /** Numbers of the workers that are there, the longest-serving first. */
  get workers(): number[] {
    return [...this.ports.keys()];
  }

  /** Starts the first worker ahead of the first job: it takes its time to load the engine. */
  warm(): void {
    if (this.ports.size === 0) this.start();
  }

  /** Calls `work` when all earlier turns have ended, however they ended. */
  inTurn<Result>(work: () => Promise<Result>): Promise<Result> {
    const turn = this.lastTurn.then(async () => {
      clearTimeout(this.idle);
      try {
        return await work();
      } finally {
        this.listener = null;
        this.shrinkLater();
      }
    });
    this.lastTurn = turn.catch(() => undefined);
    return turn;
  }

  /** Sends the reports of all workers to `listener` until its turn ends. */
  listen(listener: PoolListener): void {
    this.listener = listener;
  }

  /** Starts a worker and returns its number, which no other one ever had. */
  start(): number {
    const worker = ++this.lastWorker;
    const port = this.spawn({
      onAnswer: (answer) => {
        if (this.ports.has(worker)) this.listener?.onAnswer(worker, answer);
      },
      onDeath: (reason) => this.bury(worker, reason),
    });
    this.ports.set(worker, port);
    return worker;
  }

  /** Sends a request and moves the buffers in `transfer`; to a worker that is gone: nothing. */
  post(worker: number, request: Request, transfer: ArrayBuffer[] = []): void {
    this.ports.get(worker)?.post(request, transfer);
  }

  /** Ends a worker at once and tells nobody. */
  discard(worker: number): void {
    this.ports.get(worker)?.close();
    this.ports.delete(worker);
  }

  /** Ends all workers at once; a job that has its turn fails. The next one gets new workers. */
  close(): void {
    clearTimeout(this.idle);
    for (const worker of this.workers) this.discard(worker);
    this.listener?.onClose();
  }

  private bury(worker: number, reason: string): void {
    if (!this.ports.has(worker)) return;
    this.discard(worker);
    this.listener?.onDeath(worker, reason);
  }

  private shrinkLater(): void {
    clearTimeout(this.idle);
    const idle: unknown = setTimeout(() => {
      for (const worker of this.workers.slice(1)) this.discard(worker);
    }, mostIdle);
    this.idle = idle as ReturnType<typeof setTimeout>;
    // Only node has it: a process that has nothing else to do need not wait.
    (idle as { unref?: () => void }).unref?.();
  }
}
