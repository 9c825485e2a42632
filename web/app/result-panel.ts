import type { PrintedPage } from '../export/printed-pages.js';
import type { JobResult, Notice } from '../model/job.js';
import { otherNotices, resultNotices } from '../model/result-notices.js';
import { CutText } from './cut-text.js';
import { make } from './dom.js';
import type { DownloadBar } from './download-bar.js';
import { printOptions } from '../model/options.js';
import { changedSettings, isSameLook, lookOptions, type Options } from '../api/written-options.js';
import type { FinishedRun } from './finished-run.js';
import { leadSentence, noticeRemarks, repairRemarks, resultFacts } from './result-words.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { PrintPanel } from './print-panel.js';
import { ResultWriter } from './result-writer.js';
import { drawSheet, partsOf } from './sheet-figure.js';
import type { SheetList } from './sheet-list.js';
import type { StepsPanel } from './steps-panel.js';
import { WriterHost } from './writer-host.js';

/** A run whose sheets are drawn, but are not on the page yet. */
export interface DrawnRun {
  run: FinishedRun;
  writer: ResultWriter;
  sheets: HTMLLIElement[];
  notices: Notice[];
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
  private readonly leadCut = new CutText(
    this.place,
    this.find('#lead', HTMLElement),
    this.lead,
    this.find('#lead-more', HTMLButtonElement),
  );
  private readonly facts = this.find('#facts', HTMLElement);
  private readonly remarks = this.find('#remarks', HTMLElement);

  private readonly print = new PrintPanel(this.place);
  private readonly host = new WriterHost(this.place.life);
  /** What is on the page, and what writes it. */
  private shownRun: { run: FinishedRun; writer: ResultWriter } | null = null;
  /** Counts results, so that a later one is not replaced by one that took longer to draw. */
  private turns = 0;
  /** Whether the fields say what the document does not know yet. */
  private isLookNew = false;
  /** Called when pages look otherwise than before. */
  onLook: () => void = () => undefined;
  /** Counts changes of how sheets look. */
  private looks = 0;

  constructor(
    place: StudioPlace,
    private readonly downloads: DownloadBar,
    private readonly sheets: SheetList,
    private readonly steps: StepsPanel,
    private readonly takeLook: (look: Options) => Promise<boolean>,
  ) {
    super(place);
    this.print.onPreview = () => {
      ++this.looks;
      this.isLookNew = true;
      void this.redraw();
    };
    this.print.onChange = () => void this.offerLook();
  }

  /** How sheets shall look, as the fields say it. */
  get look(): Options {
    return lookOptions(this.print.read());
  }

  /** Hands over a look that is seen but not in the document yet, if there is one. */
  async offerLook(): Promise<void> {
    const settings = this.shownRun?.run.settings;
    if (!this.isLookNew || !settings) return;
    this.isLookNew = false;
    if (isSameLook(settings, changedSettings(settings, this.look))) return;
    // What cannot be taken now is offered again.
    if (!(await this.takeLook(this.look))) this.isLookNew = true;
  }

  /** Shows the result, or makes room for a run. */
  set open(open: boolean) {
    this.panel.hidden = !open;
    if (open) this.sheets.settle();
  }

  /** Moves the keyboard to the result. */
  focus(): void {
    this.panel.focus({ preventScroll: true });
  }

  /** Draws the sheets of a run; null if a later one was quicker. What is on the page stays. */
  async draw(run: FinishedRun): Promise<DrawnRun | null> {
    const { model, settings, result } = run;
    const turn = ++this.turns;
    const source = { result, name: stem(model.name), margin: settings.margin };
    const { measured } = this.print;
    const options = { ...printOptions(settings), measured, language: this.told.code };
    const writer = new ResultWriter(this.host, source, options);
    try {
      const sheets = await this.sheets.draw(result, writer);
      const notices = await writer.notices();
      if (turn === this.turns) return { run, writer, sheets, notices };
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
  show({ run, writer, sheets, notices }: DrawnRun, renamed = false): void {
    const { model, settings, result } = run;
    this.sheets.show(sheets, result, renamed);
    this.title.textContent = stem(model.name);
    this.lead.textContent = leadSentence(this.told, result, settings.paper);
    this.leadCut.reset();
    this.facts.replaceChildren(
      ...resultFacts(this.told, result, settings.margin).map(([label, value]) =>
        make('div', {}, make('dt', { textContent: label }), make('dd', { textContent: value })),
      ),
    );
    this.showRemarks(run, notices);
    this.downloads.offer(writer);
    this.steps.offer(result);
    // Two runs gave the same bits when this is the same: for bug reports and tests.
    this.panel.dataset['hash'] = result.hash;
    this.shownRun = { run, writer };
    if (isSameLook(settings, changedSettings(settings, this.look))) this.isLookNew = false;
    // What was changed meanwhile is newer than the document.
    if (!this.isLookNew) this.print.fill(settings, result.looks !== undefined);
    else void this.redraw();
    this.onLook();
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
    this.showRemarks(run, notices);
    this.onLook();
  }

  /** The report in words. */
  private showRemarks({ result, settings }: FinishedRun, printed: readonly Notice[]): void {
    const notices = otherNotices(resultNotices(result, settings.margin, printed));
    const remarks = [
      ...remarkList(this.told.result.repaired, repairRemarks(this.told, result)),
      ...remarkList(this.told.result.worthKnowing, noticeRemarks(this.told, notices)),
    ];
    this.remarks.replaceChildren(...remarks);
    this.remarks.hidden = remarks.length === 0;
  }

  /** The sheets of the result on the page, or of another one of the same model, drawn as those on the page are. */
  async sheetsOf(result: JobResult): Promise<HTMLLIElement[]> {
    const shown = this.shownRun;
    if (!shown) return [];
    const { model, settings } = shown.run;
    const source = { result, name: stem(model.name), margin: settings.margin };
    // The worker that writes has the result on the page already.
    const isShown = result === shown.run.result;
    const writer = isShown
      ? shown.writer
      : new ResultWriter(this.host, source, shown.writer.options);
    try {
      const sources = await Promise.all(result.sheets.map((_, sheet) => writer.sheet(sheet)));
      return sources.map((svg, index) => drawSheet(partsOf(this.told, result, index, svg)));
    } finally {
      if (!isShown) writer.close();
    }
  }

  /** All pages of the result as they are printed now. */
  async pages(): Promise<readonly PrintedPage[]> {
    return (await this.shownRun?.writer.pages()) ?? [];
  }

  /** Adds the other sheets. */
  complete(): Promise<void> {
    return this.sheets.complete();
  }
}
