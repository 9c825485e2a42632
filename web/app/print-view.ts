import type { PrintedPage } from '../export/printed-pages.js';
import {
  isRangeFault,
  parseSheetRange,
  type RangeFault,
  type SheetRange,
} from '../model/sheet-range.js';
import { isForField, make } from './dom.js';
import { pictureAddress, printPages } from './print-document.js';
import { pageWords, rangeFault, rangeWords } from './print-words.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import type { Store } from './store.js';

export interface PrintViewListener {
  /** All pages as they are printed now. */
  pages(): Promise<readonly PrintedPage[]>;
  /** They could not be drawn or printed. */
  fail(): void;
}

/** The pages of a result as they will be printed, and the buttons that print and save them. */
export class PrintView extends Panel {
  private readonly studio = this.find('.studio', HTMLElement);
  private readonly view = this.find('#print-view', HTMLElement);
  private readonly list = this.find('#print-pages', HTMLOListElement);
  private readonly opener = this.find('#print-open', HTMLButtonElement);
  private readonly printer = this.find('#print-now', HTMLButtonElement);
  private readonly field = this.find('#print-range', HTMLInputElement);
  private readonly words = this.find('#print-range-words', HTMLElement);
  private readonly look = this.find('#print', HTMLDetailsElement);
  private pages: readonly PrintedPage[] = [];
  /** Whether the fields for the look were open on the bench. */
  private hadLook = false;
  /** Counts drawings: one that a later one has overtaken is dropped. */
  private turns = 0;

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly listener: PrintViewListener,
  ) {
    super(place);
    this.opener.addEventListener('click', () => this.open());
    this.find('#print-close', HTMLButtonElement).addEventListener('click', () => this.close());
    this.printer.addEventListener('click', () => void this.print());
    this.field.addEventListener('input', () => this.choose());
    const hear = (event: Event): void => {
      if (event instanceof KeyboardEvent && this.isOpen) this.key(event);
    };
    place.ground.addEventListener('keydown', hear, { signal: place.life });
    store.on('scene', () => {
      if (store.scene !== 'result') this.leave();
    });
  }

  get isOpen(): boolean {
    return !this.view.hidden;
  }

  /** The sheets that are chosen here; all of them elsewhere, and while the field makes no sense. */
  get range(): SheetRange {
    const range = this.isOpen ? this.read() : null;
    return isRangeFault(range) ? null : range;
  }

  /** Draws the pages again: they look otherwise now, or are those of another result. */
  async refresh(): Promise<void> {
    if (!this.isOpen) return;
    const turn = ++this.turns;
    this.list.setAttribute('aria-busy', 'true');
    try {
      const pages = await this.listener.pages();
      if (turn !== this.turns) return;
      this.pages = pages;
      this.show();
    } catch (error) {
      console.error(error);
      this.listener.fail();
    } finally {
      if (turn === this.turns) this.list.removeAttribute('aria-busy');
    }
  }

  private get count(): number {
    return this.store.run?.result.sheets.length ?? 0;
  }

  private open(): void {
    if (this.store.scene !== 'result') return;
    this.view.hidden = false;
    this.studio.dataset['view'] = 'print';
    this.hadLook = this.look.open;
    this.look.open = true;
    this.printer.focus({ preventScroll: true });
    this.choose();
    void this.refresh();
  }

  /** Goes back to the bench, with the keyboard at the button that led here. */
  private close(): void {
    this.leave();
    this.opener.focus({ preventScroll: true });
  }

  private leave(): void {
    if (!this.isOpen) return;
    ++this.turns;
    this.view.hidden = true;
    this.look.open = this.hadLook;
    delete this.studio.dataset['view'];
    this.list.replaceChildren();
    this.pages = [];
  }

  private key(event: KeyboardEvent): void {
    const isPrint = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'p';
    if (isPrint) {
      event.preventDefault();
      void this.print();
    } else if (event.key === 'Escape' && !isForField(event)) this.close();
  }

  private read(): SheetRange | RangeFault {
    return parseSheetRange(this.field.value, this.count);
  }

  private choose(): void {
    const range = this.read();
    const isFault = isRangeFault(range);
    this.field.setAttribute('aria-invalid', String(isFault));
    this.words.textContent = isFault
      ? rangeFault(this.told, range, this.count)
      : rangeWords(this.told, range?.length ?? this.count, this.count);
    this.printer.disabled = isFault;
    this.show();
  }

  private get chosen(): readonly PrintedPage[] {
    const { range } = this;
    if (range === null) return this.pages;
    return this.pages.filter(({ sheet }) => sheet !== null && range.includes(sheet));
  }

  private show(): void {
    const items = this.chosen.map((page) => {
      const words = pageWords(this.told, page, this.count);
      // What it is its caption says.
      const picture = make('img', { src: pictureAddress(page), alt: '' });
      picture.width = Math.round(page.width);
      picture.height = Math.round(page.height);
      const caption = make('figcaption', { textContent: words });
      return make('li', { className: 'print-page' }, make('figure', {}, picture, caption));
    });
    this.list.replaceChildren(...items);
  }

  private async print(): Promise<void> {
    if (this.printer.disabled || this.printer.getAttribute('aria-busy') === 'true') return;
    this.printer.setAttribute('aria-busy', 'true');
    try {
      await printPages(this.studio, this.chosen, this.told.printing.frame);
    } catch (error) {
      console.error(error);
      this.listener.fail();
    } finally {
      this.printer.removeAttribute('aria-busy');
    }
  }
}
