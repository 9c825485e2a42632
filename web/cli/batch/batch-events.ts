/** What a batch tells, one JSON object on a line; `batch.schema.json` describes it field by field. */
import type { TimedEvent } from '../../core/protocol.js';
import type { MessageParams } from '../../model/message.js';
import type { Stage } from '../../model/stages.js';
import { phraseOf } from '../../words/phrase.js';
import type { Words } from '../../words/words.js';
import type { FileNote, Summary } from './record.js';

/** What is told of a model while it is unfolded: events of its job, without pictures and results. */
export type ModelEvent =
  | { type: 'stage'; stage: Stage; progress: number; seconds: number }
  | { type: 'learned'; runs: number; of: number }
  | { type: 'net'; part: number; piece: number }
  | { type: 'notice'; code: string; params: MessageParams; text: string };

/** What became of a model. */
export type ModelEnd =
  /** `seconds`: what it took. */
  | ({ type: 'done'; files: FileNote[]; seconds: number } & Summary)
  /** Nothing has changed since it was done. */
  | ({ type: 'skipped'; files: FileNote[] } & Summary)
  /** It gave nothing; the exit status is 3, or 1 if `is_internal`: then it is tried again the next time. */
  | { type: 'error'; code: string; text: string; is_internal: boolean };

/** How a batch has gone. */
export interface BatchEnd {
  type: 'end';
  done: number;
  skipped: number;
  /** Names of models that cannot be used, and of those at which the program failed. */
  refused: string[];
  failed: string[];
  /** Models that a signal has left undone. */
  left: number;
}

export type BatchEvent =
  /** `models`: in this share. */
  | { type: 'begin'; version: string; models: number; shard?: { index: number; of: number } }
  /** `model`: its name, which is that of its folder; `path`: where it was read. */
  | { type: 'model'; model: string; path: string; index: number }
  | ((ModelEvent | ModelEnd) & { model: string })
  | BatchEnd;

/** Picks what a batch tells of a job: of its progress every whole percent and every new stage. */
export class JobTeller {
  private told = '';

  /** @param tell hears what is told */
  constructor(
    private readonly words: Words,
    private readonly tell: (event: ModelEvent) => void,
  ) {}

  onEvent(event: TimedEvent): void {
    switch (event.type) {
      case 'stage':
        this.onStage(event);
        break;
      case 'learned':
        this.tell({ type: 'learned', runs: event.runs, of: event.of });
        break;
      case 'net':
        this.tell({ type: 'net', part: event.part, piece: event.piece });
        break;
      case 'notice': {
        const { code, params } = event;
        this.tell({ type: 'notice', code, params, text: phraseOf(this.words, event) });
        break;
      }
    }
  }

  private onStage({ progress, seconds, stage }: Extract<TimedEvent, { type: 'stage' }>): void {
    const now = `${stage} ${Math.floor(100 * progress)}`;
    if (now === this.told) return;
    this.told = now;
    this.tell({ type: 'stage', stage, progress, seconds });
  }
}
