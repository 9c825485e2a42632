/** Tells how a batch goes: events as JSON lines on stdout, and lines for people on stderr. */
import { batchSummary, type BatchCounts } from '../../words/batch.js';
import { sizeWords } from '../../words/summary.js';
import type { Words } from '../../words/words.js';
import { Progress } from '../progress.js';
import type { BatchEnd, BatchEvent, ModelEvent } from './batch-events.js';
import type { ListedModel } from './list-models.js';
import type { SlotOutcome } from './slot-protocol.js';

/** Counts what becomes of models while telling it. */
export class BatchReporter {
  readonly refused: string[] = [];
  readonly failed: string[] = [];
  private done = 0;
  private skipped = 0;
  private begun = 0;
  private readonly progress: Progress | null;

  /** @param all how many models there are */
  constructor(
    private readonly all: number,
    private readonly words: Words,
    isQuiet: boolean,
  ) {
    this.progress = isQuiet ? null : new Progress(process.stderr, words);
  }

  tell(event: BatchEvent): void {
    process.stdout.write(`${JSON.stringify(event)}\n`);
  }

  note(text: string): void {
    this.progress?.note(text);
  }

  onBegin({ name, path }: ListedModel): void {
    this.tell({ type: 'model', model: name, path, index: ++this.begun });
  }

  onEvent({ label, name }: ListedModel, event: ModelEvent): void {
    this.tell({ model: name, ...event });
    if (event.type === 'notice') this.note(this.words.batch.about(label, event.text));
  }

  onOutcome({ label, name, path }: ListedModel, { isCurrent, record, seconds }: SlotOutcome): void {
    if (record.status !== 'done') {
      const { code, status, text } = record;
      const isInternal = status === 'failed';
      this[status].push(name);
      this.tell({ model: name, type: 'error', code, text, is_internal: isInternal });
      console.error(this.words.batch.about(path, text));
      return;
    }
    const { files, summary } = record;
    if (isCurrent) {
      this.skipped += 1;
      this.tell({ model: name, type: 'skipped', files, ...summary });
      return;
    }
    this.done += 1;
    this.tell({ model: name, type: 'done', files, ...summary, seconds });
    summary.notices.forEach((text) => this.note(this.words.batch.about(label, text)));
    const done = this.all - this.left;
    const { command, speech } = this.words;
    const { figure } = speech;
    const size = sizeWords(this.words, summary.size_mm);
    const line = command.summary({ ...summary, name: label, size });
    this.progress?.conclude(`[${figure(done)}/${figure(this.all)}] ${line}`);
  }

  end(): void {
    const { done, failed, left, refused, skipped } = this;
    this.tell({ type: 'end', done, skipped, refused, failed, left } satisfies BatchEnd);
    const counts: BatchCounts = {
      all: this.all,
      done,
      skipped,
      refused: refused.length,
      failed: failed.length,
      left,
    };
    this.progress?.conclude(batchSummary(this.words, counts));
    if (left > 0) this.progress?.conclude(this.words.batch.goOn);
  }

  /** Models of which nothing is known yet. */
  get left(): number {
    return this.all - this.done - this.skipped - this.refused.length - this.failed.length;
  }
}
