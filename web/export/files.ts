/** The one place that knows what writes each format. */
import type { JobResult } from '../model/job.js';
import type { DrawnFormat, WrittenFile } from './formats.js';
import type { SheetRange } from '../model/sheet-range.js';
import { inPairs } from './back-page.js';
import { pagesOf, type Print } from './print.js';
import type { SheetDrawing } from './sheet-drawing.js';
import { sheetName } from './sheet-name.js';

/** What files are made of. */
export interface ExportSource {
  result: JobResult;
  print: Print;
  /** Of the file, with its ending; those of several sheets are numbered. */
  name: string;
  /** Only these sheets are written, and no page that tells how to build the model, in formats that have sheets. */
  only?: SheetRange;
}

const utf8 = new TextEncoder();

/** Writes a sheet of a print, counted from 0. */
type SheetWriter = (print: Print, sheet: number) => Uint8Array | Promise<Uint8Array>;

/** A file for each sheet, numbered where there are several: a sheet has its number also where others are left out. */
async function eachSheet(
  { print, name, only = null }: Pick<ExportSource, 'print' | 'name' | 'only'>,
  write: SheetWriter,
): Promise<WrittenFile[]> {
  const files: WrittenFile[] = [];
  const count = print.sheets.length;
  for (const sheet of only ?? print.sheets.keys()) {
    files.push({ name: sheetName(name, sheet, count), bytes: await write(print, sheet) });
  }
  return files;
}

/** `OUT-building.svg`: what files with the pages that tell how to build the model are called. */
function pagesName(name: string): string {
  const dot = name.lastIndexOf('.');
  return `${name.slice(0, dot)}-building${name.slice(dot)}`;
}

/** The same, then one for each page that tells how to build the model. */
async function eachSheetAndPage(source: ExportSource, write: SheetWriter): Promise<WrittenFile[]> {
  const { print, name, only } = source;
  const sheets = await eachSheet(source, write);
  if (only) return sheets;
  const pages = { print: pagesOf(print), name: pagesName(name) };
  return [...sheets, ...(await eachSheet(pages, write))];
}

/** The pages of the chosen sheets; all that there are if none are chosen. */
function chosenPages({ pages, sheets, backs }: Print, only: SheetRange = null): SheetDrawing[] {
  if (!only) return inPairs(pages, sheets, backs);
  const chosen = (all: readonly SheetDrawing[]): SheetDrawing[] =>
    all.filter((_, sheet) => only.includes(sheet));
  return inPairs([], chosen(sheets), chosen(backs));
}

type Writer = (source: ExportSource) => Promise<WrittenFile[]>;

// Each loads when it is first asked for: those of PDF and PNG are larger than all else.
const writers: Readonly<Record<DrawnFormat, Writer>> = {
  async fold({ result, name }) {
    const { writeFold } = await import('./fold.js');
    return [{ name, bytes: utf8.encode(writeFold(result)) }];
  },
  async svg(source) {
    const { writeSvg } = await import('./svg.js');
    return eachSheetAndPage(source, (print, sheet) => utf8.encode(writeSvg(print, sheet)));
  },
  async dxf(source) {
    const { writeDxf } = await import('./dxf.js');
    return eachSheet(source, async (...sheet) => utf8.encode(await writeDxf(...sheet)));
  },
  async png(source) {
    const { writePng } = await import('./png.js');
    return eachSheetAndPage(source, writePng);
  },
  async pdf(source) {
    const { print, name, only } = source;
    const { writePdf } = await import('./pdf.js');
    if (print.machine === 'none') {
      return [{ name, bytes: await writePdf(print, chosenPages(print, only)) }];
    }
    // A machine takes a file for each of its mats, and people one with all pages.
    const files = await eachSheet(source, (_, sheet) => writePdf(print, [print.sheets[sheet]!]));
    if (only || print.pages.length === 0) return files;
    return [...files, { name: pagesName(name), bytes: await writePdf(pagesOf(print)) }];
  },
  async glb({ result, name }) {
    const { writeGlb } = await import('./glb.js');
    return [{ name, bytes: writeGlb(result) }];
  },
};

/** All files of a result in one format: one, or one for each sheet in formats of single sheets. */
export function writeFiles(format: DrawnFormat, source: ExportSource): Promise<WrittenFile[]> {
  return writers[format](source);
}
