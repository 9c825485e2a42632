import type { JobEvent } from '../model/job.js';
import { byStage, type Stage } from '../model/stages.js';

const stageWords = byStage(({ words }) => words);

/** Follows the events of one job and puts them into words. */
export class ProgressWords {
  private stage: Stage = 'read';
  private detail = '';
  private parts = 0;
  private readonly flat = new Set<number>();
  /** In [0, 1]; never falls. */
  progress = 0;

  /** What happens now, without figures: worth saying aloud when it changes. */
  get headline(): string {
    return stageWords[this.stage];
  }

  /** What happens now, with figures where there are some. */
  get text(): string {
    return this.detail ? `${this.headline}: ${this.detail}` : this.headline;
  }

  /** Takes the next event in. */
  follow(event: JobEvent): void {
    switch (event.type) {
      case 'stage':
        if (event.stage !== this.stage) this.detail = '';
        this.stage = event.stage;
        this.progress = Math.max(this.progress, event.progress);
        break;
      case 'learned':
        this.detail = `${event.runs} of ${event.of} unfoldings tried`;
        break;
      case 'segmented':
        this.parts = event.labels.reduce((most, label) => Math.max(most, label + 1), 0);
        break;
      case 'generation':
        this.detail = this.searchDetail(event.overlaps);
        break;
      case 'net':
        this.flat.add(event.part);
        this.detail = this.searchDetail(0);
        break;
      default:
        break;
    }
  }

  private searchDetail(overlaps: number): string {
    const found = this.parts > 0 ? `${this.flat.size} of ${this.parts} done` : '';
    const left = overlaps > 0 ? `${overlaps} ${overlaps === 1 ? 'overlap' : 'overlaps'} left` : '';
    return [found, left].filter(Boolean).join(', ');
  }
}
