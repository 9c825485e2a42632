import type { Answer, Request } from './protocol.js';

/** What a worker reports to its owner. */
export interface PortListener {
  onAnswer(answer: Answer): void;
  /** The worker failed and answers nothing any more; `reason` is for people. */
  onDeath(reason: string): void;
}

/** A line to one worker. */
export interface Port {
  post(request: Request): void;
  /** Ends the worker at once. */
  close(): void;
}

/** Starts a worker that reports to `listener`. */
export type Spawn = (listener: PortListener) => Port;

/**
 * Keeps one worker, starts it when first needed and replaces it when it was thrown away. Jobs take
 * turns, so that a worker that must be replaced takes only its own job with it.
 */
export class Transport {
  private port: Port | null = null;
  private listener: PortListener | null = null;
  private lastTurn: Promise<unknown> = Promise.resolve();

  constructor(private readonly spawn: Spawn) {}

  /** Calls `work` when all earlier turns have ended, however they ended. */
  inTurn<Result>(work: () => Promise<Result>): Promise<Result> {
    const turn = this.lastTurn.then(work);
    this.lastTurn = turn.catch(() => undefined);
    return turn;
  }

  /** The worker, reporting to `listener` from now on. */
  open(listener: PortListener): Port {
    this.listener = listener;
    this.port ??= this.start();
    return this.port;
  }

  /** Ends the worker; the next job gets a new one. */
  close(): void {
    this.port?.close();
    this.port = null;
    this.listener = null;
  }

  private start(): Port {
    const port: Port = this.spawn({
      onAnswer: (answer) => {
        if (this.port === port) this.listener?.onAnswer(answer);
      },
      onDeath: (reason) => {
        if (this.port !== port) return;
        const { listener } = this;
        this.close();
        listener?.onDeath(reason);
      },
    });
    return port;
  }
}
