import type { JobResult } from '../model/job.js';
import { pieceLetter } from '../model/piece-letter.js';
import { partColour } from '../view/part-colours.js';
import { partHatch } from '../view/part-hatches.js';
import { sheetPicture } from '../view/sheet-picture.js';
import { find, make } from './dom.js';

/** The sheets as they will be printed, with the parts in colour. */
export class SheetList {
  private readonly list = find('#sheets', HTMLOListElement);
  private readonly zoom = find('#zoom', HTMLInputElement);

  constructor() {
    this.zoom.addEventListener('input', () => this.resize());
    // On a small screen a sheet is at first as wide as there is room.
    this.zoom.value = String(Math.min(this.zoom.valueAsNumber, window.innerWidth - 32));
  }

  /** Draws all sheets with the exporter that also writes the files: screen and paper agree. */
  async show(result: JobResult): Promise<void> {
    const { writeSvg } = await import('../export/svg.js');
    const widest = Math.max(...result.sheets.map(({ width }) => width));
    const items = result.sheets.map((sheet, index) => {
      const pieces = result.pieces.filter((piece) => piece.sheet === index);
      const paints = new Map(
        pieces.map(({ id, part }) => [
          pieceLetter(id),
          { colour: partColour(part), hatch: partHatch(part) },
        ]),
      );
      const number = `Sheet ${index + 1} of ${result.sheets.length}`;
      const names = [...paints.keys()].join(', ');
      const caption = `${number}: ${pieces.length === 1 ? 'piece' : 'pieces'} ${names}`;
      const picture = sheetPicture(writeSvg(result, index), paints, caption);
      const figure = make('figure', {}, picture, make('figcaption', { textContent: caption }));
      figure.style.setProperty('--share', String(sheet.width / widest));
      return make('li', { className: 'sheet' }, figure);
    });
    this.list.replaceChildren(...items);
    this.resize();
  }

  private resize(): void {
    this.list.style.setProperty('--sheet-width', `${this.zoom.value}px`);
  }
}
