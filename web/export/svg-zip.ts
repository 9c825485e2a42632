import { strToU8, zipSync, type Zippable } from 'fflate';
import type { Print } from './print.js';
import { svgFiles } from './svg-files.js';

// The first day that a zip archive can name: the same result gives the same bytes.
const noDate = new Date(1980, 0, 1);

/** All sheets and pages as SVG files in one zip archive; `name` (with its ending .svg) names the files. */
export function writeSvgZip(print: Print, name: string): Uint8Array {
  const files: Zippable = {};
  for (const file of svgFiles(print, name)) files[file.name] = strToU8(file.text);
  return zipSync(files, { mtime: noDate });
}
