import type { Stage } from '../model/job.js';
import type { TimedEvent } from './protocol.js';

/** Progress events in any second. */
const mostPerSecond = 10;

/** Between two of them, in ms; leaves room in each second for two stages that begin. */
const interval = 125;

/** Kinds of which the latest tells all that earlier ones told. */
function isProgress({ type }: TimedEvent): boolean {
  return type === 'stage' || type === 'learned' || type === 'generation';
}

/**
 * Lets at most ten progress events a second through and holds back only the latest of each kind,
 * so that the last one always arrives. A stage that begins does not wait for its turn, because work
 * that cannot be interrupted may follow. All other events pass at once.
 */
export class EventThrottle {
  private readonly held = new Map<TimedEvent['type'], TimedEvent>();
  /** When the events of the last second were sent. */
  private sent: number[] = [];
  private stage: Stage | null = null;
  private stageBegins = false;

  constructor(private readonly send: (event: TimedEvent) => void) {}

  push(event: TimedEvent): void {
    if (event.type === 'stage' && event.stage !== this.stage) {
      this.stage = event.stage;
      this.stageBegins = true;
    }
    if (isProgress(event)) this.held.set(event.type, event);
    else this.send(event);
  }

  /** Sends one of the events that are held back if it is time for it; `now` in ms. */
  release(now: number): void {
    this.sent = this.sent.filter((time) => now - time < 1000);
    const last = this.sent.at(-1) ?? -Infinity;
    if (this.sent.length >= mostPerSecond) return;
    if (!this.stageBegins && now - last < interval) return;
    const type = this.stageBegins ? 'stage' : this.held.keys().next().value;
    const event = type && this.held.get(type);
    if (!event) return;
    this.held.delete(event.type);
    this.sent.push(now);
    if (event.type === 'stage') this.stageBegins = false;
    this.send(event);
  }

  /** Sends whatever is held back, before the event that ends a job. */
  flush(): void {
    for (const event of this.held.values()) this.send(event);
    this.held.clear();
  }
}
