import type { JobResult } from '../model/job.js';
import { partColour } from '../model/part-colours.js';
import { partHatch } from '../view/part-hatches.js';
import { markSheet } from '../view/sheet-marks.js';
import { sheetPicture } from '../view/sheet-picture.js';
import { find, make } from './dom.js';
import { nextFrame } from './next-frame.js';
import type { ResultWriter } from './result-writer.js';
import type { MarksBySheet } from './step-marks.js';

/** One sheet with its caption, from its SVG. */
function drawSheet(result: JobResult, index: number, source: string): HTMLElement {
  const pieces = result.pieces.filter((piece) => piece.sheet === index);
  const paints = new Map(
    pieces.map(({ name, part }) => [name, { colour: partColour(part), hatch: partHatch(part) }]),
  );
  const number = `Sheet ${index + 1} of ${result.sheets.length}`;
  const names = [...paints.keys()].join(', ');
  const caption = `${number}: ${pieces.length === 1 ? 'piece' : 'pieces'} ${names}`;
  const picture = sheetPicture(source, paints, caption);
  return make('figure', {}, picture, make('figcaption', { textContent: caption }));
}

/** The sheets as they will be printed, with the parts in colour. */
export class SheetList {
  private readonly list = find('#sheets', HTMLOListElement);
  private readonly zoom = find('#zoom', HTMLInputElement);
  /** Sheets that were drawn, but are not on the page yet. */
  private coming: HTMLLIElement[] = [];
  private sheets: HTMLLIElement[] = [];
  private marks: MarksBySheet = new Map();

  constructor() {
    this.zoom.addEventListener('input', () => this.resize());
    // On a small screen a sheet is at first as wide as there is room.
    this.zoom.value = String(Math.min(this.zoom.valueAsNumber, window.innerWidth - 32));
  }

  /** Draws all sheets with the exporter that also writes the files: screen and paper agree. */
  async draw(result: JobResult, writer: ResultWriter): Promise<HTMLLIElement[]> {
    const widest = Math.max(...result.sheets.map(({ width }) => width));
    const items: HTMLLIElement[] = [];
    for (const [index, sheet] of result.sheets.entries()) {
      const figure = drawSheet(result, index, await writer.sheet(index));
      figure.style.setProperty('--share', String(sheet.width / widest));
      items.push(make('li', { className: 'sheet' }, figure));
    }
    return items;
  }

  /** Puts the first of the sheets that were drawn in the place of those before. */
  show(sheets: HTMLLIElement[]): void {
    this.sheets = sheets;
    this.marks = new Map();
    this.list.replaceChildren(...sheets.slice(0, 1));
    this.coming = sheets.slice(1);
    this.resize();
  }

  /** Adds the other sheets, one in each frame: all at once they would keep the page for too long. */
  async complete(): Promise<void> {
    while (this.coming.length > 0) {
      await nextFrame();
      this.list.append(...this.coming.splice(0, 1));
    }
  }

  /** Puts sheets of the same result that look otherwise in the place of those on the page. */
  replace(sheets: HTMLLIElement[]): void {
    this.sheets = sheets;
    this.coming = [];
    this.list.replaceChildren(...sheets);
    this.mark(this.marks);
  }

  /** Marks lines on the sheets, in place of those that were marked before. */
  mark(marks: MarksBySheet): void {
    this.marks = marks;
    this.sheets.forEach((sheet, index) => {
      const svg = sheet.querySelector('svg');
      if (svg) markSheet(svg, marks.get(index) ?? []);
    });
  }

  private resize(): void {
    this.list.style.setProperty('--sheet-width', `${this.zoom.value}px`);
  }
}
