import type { StageSeconds } from '../model/stage-seconds.js';
import { byStage, type Stage } from '../model/stages.js';

/** Adds up the time that a job spends in each stage. All times in ms. */
export class StageClock {
  private readonly spent = byStage(() => 0);
  private stage: Stage = 'read';
  private folding = 0;
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

  /** So much of the time of a stage went into how nets fold. */
  fold(time: number): void {
    this.folding += time;
  }

  /** Seconds since the job began. */
  elapsed(now: number): number {
    return (now - this.start) / 1000;
  }

  /** Seconds spent so far. */
  seconds(): StageSeconds {
    const spent = byStage((stage) => this.spent[stage] / 1000);
    return { ...spent, fold: this.folding / 1000, total: this.elapsed(this.last) };
  }
}
