import type { PrintedPage } from '../export/printed-pages.js';
import type { RangeFault } from '../model/sheet-range.js';
import type { Words } from '../words/words.js';

/** What a page of the print view is: "Sheet 2 of 3, 210 × 297 mm". */
export function pageWords({ printing }: Words, page: PrintedPage, sheets: number): string {
  const sheet = page.sheet === null ? null : page.sheet + 1;
  return printing.page(sheet, sheets, page.width, page.height);
}

/** Which sheets are printed and saved. */
export function rangeWords({ printing }: Words, chosen: number, sheets: number): string {
  return chosen === sheets ? printing.allSheets(sheets) : printing.someSheets(chosen, sheets);
}

/** Why what was written chooses no sheets. */
export function rangeFault({ printing }: Words, fault: RangeFault, sheets: number): string {
  return fault === 'beyond' ? printing.beyondRange(sheets) : printing.unreadableRange;
}
