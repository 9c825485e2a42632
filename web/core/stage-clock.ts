import type { Stage } from '../model/job.js';
import type { StageSeconds } from '../model/stage-seconds.js';

/** Adds up the time that a job spends in each stage. All times in ms. */
export class StageClock {
  private readonly spent: Record<Stage, number> = {
    read: 0,
    learn: 0,
    cluster: 0,
    search: 0,
    compact: 0,
    paper: 0,
  };
  private stage: Stage = 'read';
  private last: number;

  constructor(private readonly start: number) {
    this.last = start;
  }

  /** The time since the last call went into `stage`, or, if unknown, the same one as before. */
  spend(now: number, stage: Stage = this.stage): void {
    this.spent[stage] += now - this.last;
    this.stage = stage;
    this.last = now;
  }

  /** Seconds since the job began. */
  elapsed(now: number): number {
    return (now - this.start) / 1000;
  }

  /** Seconds spent so far. */
  seconds(): StageSeconds {
    const { read, learn, cluster, search, compact, paper } = this.spent;
    return {
      read: read / 1000,
      learn: learn / 1000,
      cluster: cluster / 1000,
      search: search / 1000,
      // Motions are part of the search.
      fold: 0,
      compact: compact / 1000,
      paper: paper / 1000,
      total: this.elapsed(this.last),
    };
  }
}
