import type { Print } from './print.js';
import { sheetName } from './sheet-name.js';
import { writePageSvg, writeSvg } from './svg.js';

/** A file that is text. */
export interface TextFile {
  name: string;
  text: string;
}

/** `OUT-building.svg`, or `OUT-building-1.svg` and so on for several. */
function pageName(name: string, page: number, count: number): string {
  const dot = name.lastIndexOf('.');
  return sheetName(`${name.slice(0, dot)}-building${name.slice(dot)}`, page, count);
}

/**
 * A file for each sheet, then one for each page that tells how to build the model. `name` (with its ending
 * .svg) names them.
 */
export function svgFiles(print: Print, name: string): TextFile[] {
  const { pages, sheets } = print;
  return [
    ...sheets.map((_, sheet) => ({
      name: sheetName(name, sheet, sheets.length),
      text: writeSvg(print, sheet),
    })),
    ...pages.map((_, page) => ({
      name: pageName(name, page, pages.length),
      text: writePageSvg(print, page),
    })),
  ];
}
