import type { Answer, Request } from './protocol.js';

/** What a worker reports to its owner. */
export interface PortListener {
  onAnswer(answer: Answer): void;
  /** The worker failed and answers nothing any more; `reason` is for people. */
  onDeath(reason: string): void;
}

/** A line to one worker. */
export interface Port {
  post(request: Request, transfer: ArrayBuffer[]): void;
  /** Ends the worker at once. */
  close(): void;
}

/** Starts a worker that reports to `listener`. */
export type Spawn = (listener: PortListener) => Port;
