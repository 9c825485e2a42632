import type { TimedResult } from '../core/client.js';
import type { JobResult, Notice } from '../model/job.js';
import { find, make } from './dom.js';
import type { DownloadBar } from './download-bar.js';
import type { Wishes } from './options-form.js';
import type { ModelFile } from './model-file.js';
import {
  leadSentence,
  netRemarks,
  noticeRemarks,
  repairRemarks,
  resultFacts,
} from './result-words.js';
import type { PrintPanel } from './print-panel.js';
import { ResultWriter } from './result-writer.js';
import type { SheetList } from './sheet-list.js';
import type { StepsPanel } from './steps-panel.js';

/** A finished run: what was asked for and what came out. */
export interface FinishedRun {
  model: ModelFile;
  wishes: Wishes;
  result: TimedResult;
}

/** The file's name without its ending. */
function stem(fileName: string): string {
  return fileName.replace(/\.[^.]*$/, '') || 'model';
}

function remarkList(title: string, remarks: string[]): HTMLElement[] {
  if (remarks.length === 0) return [];
  const items = remarks.map((textContent) => make('li', { textContent }));
  return [make('h3', { textContent: title }), make('ul', {}, ...items)];
}

/** The summary of a result with its downloads, its sheets and the steps to build it. */
export class ResultPanel {
  private readonly panel = find('#result', HTMLElement);
  private readonly title = find('#result-title', HTMLElement);
  private readonly lead = find('#result-lead', HTMLElement);
  private readonly facts = find('#facts', HTMLElement);
  private readonly remarks = find('#remarks', HTMLElement);

  /** What is on the page, and what writes it. */
  private shownRun: { run: FinishedRun; writer: ResultWriter } | null = null;
  /** Counts results and looks, so that a later one is not replaced by one that took longer to draw. */
  private turns = 0;

  constructor(
    private readonly downloads: DownloadBar,
    private readonly sheets: SheetList,
    private readonly steps: StepsPanel,
    private readonly print: PrintPanel,
  ) {
    print.onChange = () => void this.redraw();
  }

  /** Whether there is a result on the page. */
  get shown(): boolean {
    return !this.panel.hidden;
  }

  /** Makes room for a run; the result can be restored. */
  hide(): void {
    this.panel.hidden = true;
  }

  /** Whether there ever was a result. */
  get exists(): boolean {
    return this.panel.dataset['hash'] !== undefined;
  }

  /** Shows the last result again, if there ever was one. */
  restore(): void {
    this.panel.hidden = !this.exists;
  }

  /** Moves the keyboard to the result. */
  focus(): void {
    this.panel.focus({ preventScroll: true });
  }

  /**
   * Replaces the result on the page, but for all sheets after the first; returns its one-sentence
   * summary, or null if a later result was quicker to draw.
   *
   * @param renamed it has the pieces of the one before with other names: all sheets are replaced
   */
  async show(run: FinishedRun, renamed = false): Promise<string | null> {
    const { model, wishes, result } = run;
    const turn = ++this.turns;
    const name = stem(model.name);
    const source = { result, name, margin: wishes.job.margin };
    const writer = new ResultWriter(source, this.print.read());
    const sheets = await this.sheets.draw(result, writer);
    const notices = await writer.notices();
    if (turn !== this.turns) {
      writer.close();
      return null;
    }
    this.sheets.show(sheets, result, renamed);
    const lead = leadSentence(result, wishes.paper);
    this.title.textContent = name;
    this.lead.textContent = lead;
    this.facts.replaceChildren(
      ...resultFacts(result).map(([label, value]) =>
        make('div', {}, make('dt', { textContent: label }), make('dd', { textContent: value })),
      ),
    );
    this.tell(result, notices);
    this.downloads.offer(writer);
    this.steps.offer(result.pieces);
    // Two runs gave the same bits when this is the same: for bug reports and tests.
    this.panel.dataset['hash'] = result.hash;
    this.panel.hidden = false;
    this.shownRun = { run, writer };
    return lead;
  }

  /** Draws the sheets once more, as the print options are now. */
  private async redraw(): Promise<void> {
    const shown = this.shownRun;
    if (!shown) return;
    const turn = ++this.turns;
    const { run, writer } = shown;
    writer.options = this.print.read();
    const sheets = await this.sheets.draw(run.result, writer);
    const notices = await writer.notices();
    if (turn !== this.turns) return;
    this.sheets.replace(sheets);
    this.tell(run.result, notices);
  }

  /** The report in words. */
  private tell(result: JobResult, notices: readonly Notice[]): void {
    const remarks = [
      ...remarkList('Repaired before unfolding', repairRemarks(result)),
      ...remarkList('Worth knowing', [...netRemarks(result), ...noticeRemarks(notices)]),
    ];
    this.remarks.replaceChildren(...remarks);
    this.remarks.hidden = remarks.length === 0;
  }

  /** Adds the other sheets. */
  complete(): Promise<void> {
    return this.sheets.complete();
  }
}
