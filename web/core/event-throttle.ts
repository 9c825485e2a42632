import type { TimedEvent } from './protocol.js';

/** Between two events that only report progress: at most ten a second. */
const interval = 100;

/** Kinds of which the latest tells all that earlier ones told. */
function isProgress({ type }: TimedEvent): boolean {
  return type === 'stage' || type === 'learned' || type === 'generation';
}

/**
 * Lets at most ten progress events a second through and holds back only the latest of each kind,
 * so that the last one always arrives. All other events pass at once.
 */
export class EventThrottle {
  private readonly held = new Map<TimedEvent['type'], TimedEvent>();
  private lastTime = -Infinity;

  constructor(private readonly send: (event: TimedEvent) => void) {}

  push(event: TimedEvent): void {
    if (isProgress(event)) this.held.set(event.type, event);
    else this.send(event);
  }

  /** Sends the event that has waited longest if the last one is long enough ago; `now` in ms. */
  release(now: number): void {
    const next = this.held.entries().next();
    if (next.done || now - this.lastTime < interval) return;
    const [type, event] = next.value;
    this.held.delete(type);
    this.lastTime = now;
    this.send(event);
  }

  /** Sends whatever is held back, before the event that ends a job. */
  flush(): void {
    for (const event of this.held.values()) this.send(event);
    this.held.clear();
  }
}
