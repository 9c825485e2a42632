import { inPairs } from './back-page.js';
import { pagesOf, type Print } from './print.js';
import { writeSvg } from './svg.js';

/** A page as it comes out of a printer. */
export interface PrintedPage {
  /** The same SVG that is saved. */
  svg: string;
  /** mm. */
  width: number;
  height: number;
  /** Of the sheet that it shows, or the back of which it is, from 0; null: it tells how to build the model. */
  sheet: number | null;
}

/** Writes all pages of a print, in the order in which a printer takes them. */
export function printedPages(print: Print): PrintedPage[] {
  const { backs, pages, sheets } = print;
  // A machine's sheets look otherwise than the pages that people read.
  const guides = pagesOf(print);
  const all = inPairs(pages, sheets, backs);
  return all.map((page, index): PrintedPage => {
    const front = sheets.indexOf(page);
    const sheet = front >= 0 ? front : backs.indexOf(page);
    const source = sheet < 0 ? guides : print;
    const svg = writeSvg({ ...source, sheets: all }, index);
    return { svg, width: page.width, height: page.height, sheet: sheet < 0 ? null : sheet };
  });
}
