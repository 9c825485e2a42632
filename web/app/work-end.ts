import type { TimedEvent } from '../core/protocol.js';

/** How the present work may be ended before its time: it is left, or stopped for the nets that it has found. */
export class WorkEnd {
  private readonly leaving = new AbortController();
  private readonly stopping = new AbortController();
  private hasNets = false;

  /** Ends the work; all is as it was. */
  get left(): AbortSignal {
    return this.leaving.signal;
  }

  /** Ends a run, which comes to the nets that are there. */
  get stopped(): AbortSignal {
    return this.stopping.signal;
  }

  /** Whether there is something that `stop` would hand over, as far as the work has told. */
  get canStop(): boolean {
    return this.hasNets && !this.isEnding;
  }

  /** Whether a person has ended it in either way. */
  get isEnding(): boolean {
    return this.left.aborted || this.stopped.aborted;
  }

  leave(): void {
    this.leaving.abort();
  }

  stop(): void {
    this.stopping.abort();
  }

  /** Takes in what the work tells; true when there is something to hand over for the first time. */
  follow({ type }: TimedEvent): boolean {
    const isFirst = type === 'net' && !this.hasNets;
    this.hasNets ||= isFirst;
    return isFirst;
  }
}
