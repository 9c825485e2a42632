import type { WriteStream } from 'node:tty';
import type { TimedEvent } from '../core/protocol.js';
import type { Stage } from '../model/stages.js';
import { phraseOf } from '../words/phrase.js';
import type { Words } from '../words/words.js';

/**
 * Tells on a stream how a job goes, one line that changes on a terminal, else one per stage; what there
 * is to know of it, each thing once; and at last what came out.
 */
export class Progress {
  private stage: Stage | null = null;
  private readonly said = new Set<string>();

  constructor(
    private readonly stream: WriteStream,
    private readonly words: Words,
  ) {}

  readonly onEvent = (event: TimedEvent): void => {
    if (event.type === 'notice') this.note(phraseOf(this.words, event));
    if (event.type === 'stage') this.report(event.stage, event.progress);
  };

  /** Writes a phrase on a line of its own, unless it was said before. */
  note(text: string): void {
    if (this.said.has(text)) return;
    this.said.add(text);
    this.clear();
    this.stream.write(`${this.words.command.note(text)}\n`);
  }

  /** Writes the last line. */
  conclude(summary: string): void {
    this.clear();
    this.stream.write(`${summary}\n`);
  }

  /** Leaves the terminal's line empty for whatever comes next. */
  clear(): void {
    if (this.stream.isTTY) this.stream.write('\r\x1b[K');
  }

  private report(stage: Stage, progress: number): void {
    const { stageLines } = this.words.run;
    if (this.stream.isTTY) {
      const percent = String(Math.floor(progress * 100)).padStart(3);
      this.stream.write(`\r\x1b[K${percent} % ${stageLines[stage]}`);
    } else if (stage !== this.stage) {
      this.stream.write(`${stageLines[stage]}\n`);
    }
    this.stage = stage;
  }
}
