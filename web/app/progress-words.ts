import type { TimedEvent } from '../core/protocol.js';
import { PartsProgress } from '../model/parts-progress.js';
import type { Stage } from '../model/stages.js';
import { unknownEnd, withReading } from '../model/time-left.js';
import type { Words } from '../words/words.js';

/** Seconds below which it is over before one has read it, and above which minutes are told. */
const [fewSeconds, manySeconds] = [5, 90];

/** How long a run still takes, rounded up; nothing if that cannot be known, or if it is over at once. */
export function timeWords({ run }: Words, seconds: number | null): string {
  if (seconds === null || seconds < fewSeconds) return '';
  if (seconds > manySeconds) return run.minutesLeft(Math.ceil(seconds / 60));
  return run.secondsLeft(5 * Math.ceil(seconds / 5));
}

/** Follows the events of one job and puts them into words. */
export class ProgressWords {
  private stage: Stage = 'read';
  private detail = '';
  private readonly parts = new PartsProgress();
  private end = unknownEnd;
  private second = 0;
  /** In [0, 1]; never falls. */
  progress = 0;

  constructor(private readonly words: Words) {}

  /** What happens now, without figures: worth saying aloud when it changes. */
  get headline(): string {
    return this.words.run.stages[this.stage];
  }

  /** What happens now, with figures where there are some. */
  get text(): string {
    return this.detail ? this.words.run.detailed(this.headline, this.detail) : this.headline;
  }

  /** How long it still takes, as far as that can be known. */
  get left(): string {
    const { end } = this.end;
    return timeWords(this.words, end === null ? null : end - this.second);
  }

  /** Takes the next event in. */
  follow(event: TimedEvent): void {
    this.parts.follow(event);
    switch (event.type) {
      case 'stage':
        if (event.stage !== this.stage) this.detail = '';
        this.stage = event.stage;
        this.progress = Math.max(this.progress, event.progress);
        this.second = event.seconds;
        this.end = withReading(this.end, { second: event.seconds, progress: this.progress });
        break;
      case 'learned':
        this.detail = this.words.run.learned(event.runs, event.of);
        break;
      case 'generation':
      case 'net':
        this.detail = this.searchDetail();
        break;
      default:
        break;
    }
  }

  private searchDetail(): string {
    const { done, overlaps, parts } = this.parts;
    const { run } = this.words;
    const found = parts > 0 ? run.partsDone(done, parts) : '';
    const left = overlaps ? run.overlapsLeft(overlaps) : '';
    return [found, left].filter(Boolean).join(', ');
  }
}
