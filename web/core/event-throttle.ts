import type { Stage } from '../model/stages.js';
import type { TimedEngineEvent } from './protocol.js';

/** Batches in any second. */
const mostPerSecond = 10;

/** Between two of them, in ms; leaves room in each second for two stages that begin. */
const interval = 125;

/** Events of which a later one of the same kind tells all that this one does. */
function isPassing(event: TimedEngineEvent): boolean {
  return event.type === 'stage' || (event.type === 'learned' && !event.matrix);
}

/**
 * Sends events in batches, at most ten a second. Drops only what a later event of the same batch
 * tells as well: of `stage`, and of `learned` without a matrix, the last one remains. A stage that
 * begins does not wait for its turn, because work that cannot be interrupted may follow.
 */
export class EventThrottle {
  private held: TimedEngineEvent[] = [];
  /** When the batches of the last second were sent. */
  private sent: number[] = [];
  private stage: Stage | null = null;
  private stageBegins = false;

  constructor(private readonly send: (events: TimedEngineEvent[]) => void) {}

  push(event: TimedEngineEvent): void {
    if (event.type === 'stage' && event.stage !== this.stage) {
      this.stage = event.stage;
      this.stageBegins = true;
    }
    if (isPassing(event)) {
      // There is at most one: the one before took away those before it.
      const before = this.held.findIndex((e) => e.type === event.type && isPassing(e));
      if (before >= 0) this.held.splice(before, 1);
    }
    this.held.push(event);
  }

  /** Sends what is held back if it is time for it; `now` in ms. */
  release(now: number): void {
    this.sent = this.sent.filter((time) => now - time < 1000);
    const last = this.sent.at(-1) ?? -Infinity;
    if (this.sent.length >= mostPerSecond) return;
    if (!this.stageBegins && now - last < interval) return;
    if (this.held.length === 0) return;
    this.sent.push(now);
    this.flush();
  }

  /** Sends whatever is held back, at the end of a job. */
  flush(): void {
    const events = this.held;
    this.held = [];
    this.stageBegins = false;
    if (events.length > 0) this.send(events);
  }
}
