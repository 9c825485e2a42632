import { strToU8, zipSync, type Zippable } from 'fflate';
import type { Print } from './print.js';
import { sheetName } from './sheet-name.js';
import { writeSvg } from './svg.js';

// The first day that a zip archive can name: the same result gives the same bytes.
const noDate = new Date(1980, 0, 1);

/** All sheets as SVG files in one zip archive; `name` (with its ending .svg) names the files. */
export function writeSvgZip(print: Print, name: string): Uint8Array {
  const count = print.sheets.length;
  const files: Zippable = {};
  print.sheets.forEach((_, sheet) => {
    files[sheetName(name, sheet, count)] = strToU8(writeSvg(print, sheet));
  });
  return zipSync(files, { mtime: noDate });
}
