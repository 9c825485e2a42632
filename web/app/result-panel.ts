import type { JobResult, Notice } from '../model/job.js';
import { make } from './dom.js';
import type { DownloadBar } from './download-bar.js';
import type { FinishedRun } from './finished-run.js';
import {
  leadSentence,
  netRemarks,
  noticeRemarks,
  repairRemarks,
  resultFacts,
} from './result-words.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { PrintPanel } from './print-panel.js';
import { ResultWriter } from './result-writer.js';
import type { SheetList } from './sheet-list.js';
import type { StepsPanel } from './steps-panel.js';

/** A run whose sheets are drawn, but are not on the page yet. */
export interface DrawnRun {
  run: FinishedRun;
  writer: ResultWriter;
  sheets: HTMLLIElement[];
  notices: Notice[];
  /** Which look the sheets have. */
  look: number;
}

/** The file's name without folders and its ending. */
function stem(fileName: string): string {
  return fileName.replace(/^.*\//, '').replace(/\.[^.]*$/, '') || 'model';
}

function remarkList(title: string, remarks: string[]): HTMLElement[] {
  if (remarks.length === 0) return [];
  const items = remarks.map((textContent) => make('li', { textContent }));
  return [make('h3', { textContent: title }), make('ul', {}, ...items)];
}

/** The summary of a result with its downloads, its sheets and the steps to build it. */
export class ResultPanel extends Panel {
  private readonly panel = this.find('#result', HTMLElement);
  private readonly title = this.find('#result-title', HTMLElement);
  private readonly lead = this.find('#result-lead', HTMLElement);
  private readonly facts = this.find('#facts', HTMLElement);
  private readonly remarks = this.find('#remarks', HTMLElement);

  private readonly print = new PrintPanel(this.place);
  /** What is on the page, and what writes it. */
  private shownRun: { run: FinishedRun; writer: ResultWriter } | null = null;
  /** Counts results, so that a later one is not replaced by one that took longer to draw. */
  private turns = 0;
  /** Counts changes of how sheets look. */
  private looks = 0;

  constructor(
    place: StudioPlace,
    private readonly downloads: DownloadBar,
    private readonly sheets: SheetList,
    private readonly steps: StepsPanel,
  ) {
    super(place);
    this.print.onChange = () => {
      ++this.looks;
      void this.redraw();
    };
  }

  /** Shows the result, or makes room for a run. */
  set open(open: boolean) {
    this.panel.hidden = !open;
  }

  /** Moves the keyboard to the result. */
  focus(): void {
    this.panel.focus({ preventScroll: true });
  }

  /** Draws the sheets of a run; null if a later one was quicker. What is on the page stays. */
  async draw(run: FinishedRun): Promise<DrawnRun | null> {
    const { model, settings, result } = run;
    const [turn, look] = [++this.turns, this.looks];
    const source = { result, name: stem(model.name), margin: settings.margin };
    const writer = new ResultWriter(source, this.print.read(), this.place.life);
    try {
      const sheets = await this.sheets.draw(result, writer);
      const notices = await writer.notices();
      if (turn === this.turns) return { run, writer, sheets, notices, look };
    } catch (error) {
      writer.close();
      throw error;
    }
    writer.close();
    return null;
  }

  /**
   * Replaces the result on the page, but for all sheets after the first, at once.
   *
   * @param renamed it has the pieces of the one before with other names: all sheets are replaced
   */
  show({ run, writer, sheets, notices, look }: DrawnRun, renamed = false): void {
    const { model, settings, result } = run;
    this.sheets.show(sheets, result, renamed);
    this.title.textContent = stem(model.name);
    this.lead.textContent = leadSentence(result, settings.paper);
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
    this.shownRun = { run, writer };
    if (look !== this.looks) void this.redraw();
  }

  /** Draws the sheets once more, as the print options are now. */
  private async redraw(): Promise<void> {
    const shown = this.shownRun;
    if (!shown) return;
    const { looks } = this;
    const { run, writer } = shown;
    writer.options = this.print.read();
    const sheets = await this.sheets.draw(run.result, writer);
    const notices = await writer.notices();
    if (shown !== this.shownRun || looks !== this.looks) return;
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
