import type { EngineEvent } from '../model/job.js';

/** Ms between two drafts, over what the first of them took: so they cost a twentieth of the time. */
const dearness = 20;

/** When a job tells what could be printed already: as soon as every part has a net, and while nets get better. */
export class DraftPace {
  private due = Infinity;

  follow(events: readonly EngineEvent[]): void {
    for (const event of events) {
      if (event.type !== 'stage') continue;
      if (event.stage === 'paper') this.due = Infinity;
      else if (event.stage === 'compact' && this.due === Infinity) this.due = 0;
    }
  }

  /** @param now ms */
  isDue(now: number): boolean {
    return now >= this.due;
  }

  /** One was made between these times; ms. */
  made(from: number, to: number): void {
    this.due = to + dearness * (to - from);
  }
}
