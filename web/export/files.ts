/** The one place that knows what writes each format. */
import type { JobResult } from '../model/job.js';
import type { ExportFormat, WrittenFile } from './formats.js';
import { pagesOf, type Print } from './print.js';
import { sheetName } from './sheet-name.js';

/** What files are made of. */
export interface ExportSource {
  result: JobResult;
  print: Print;
  /** Of the file, with its ending; those of several sheets are numbered. */
  name: string;
}

const utf8 = new TextEncoder();

/** Writes a sheet of a print, counted from 0. */
type SheetWriter = (print: Print, sheet: number) => Uint8Array | Promise<Uint8Array>;

/** A file for each sheet, numbered where there are several. */
async function eachSheet(print: Print, name: string, write: SheetWriter): Promise<WrittenFile[]> {
  const files: WrittenFile[] = [];
  const count = print.sheets.length;
  for (let sheet = 0; sheet < count; ++sheet) {
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
async function eachSheetAndPage(
  { print, name }: ExportSource,
  write: SheetWriter,
): Promise<WrittenFile[]> {
  const sheets = await eachSheet(print, name, write);
  return [...sheets, ...(await eachSheet(pagesOf(print), pagesName(name), write))];
}

type Writer = (source: ExportSource) => Promise<WrittenFile[]>;

// Each loads when it is first asked for: those of PDF and PNG are larger than all else.
const writers: Readonly<Record<ExportFormat, Writer>> = {
  async fold({ result, name }) {
    const { writeFold } = await import('./fold.js');
    return [{ name, bytes: utf8.encode(writeFold(result)) }];
  },
  async svg(source) {
    const { writeSvg } = await import('./svg.js');
    return eachSheetAndPage(source, (print, sheet) => utf8.encode(writeSvg(print, sheet)));
  },
  async dxf({ print, name }) {
    const { writeDxf } = await import('./dxf.js');
    const write: SheetWriter = async (...sheet) => utf8.encode(await writeDxf(...sheet));
    return eachSheet(print, name, write);
  },
  async png(source) {
    const { writePng } = await import('./png.js');
    return eachSheetAndPage(source, writePng);
  },
  async pdf({ print, name }) {
    const { writePdf } = await import('./pdf.js');
    if (print.machine === 'none') return [{ name, bytes: await writePdf(print) }];
    // A machine takes a file for each of its mats, and people one with all pages.
    const files = await eachSheet(print, name, (_, sheet) =>
      writePdf(print, [print.sheets[sheet]!]),
    );
    if (print.pages.length === 0) return files;
    return [...files, { name: pagesName(name), bytes: await writePdf(pagesOf(print)) }];
  },
  async glb({ result, name }) {
    const { writeGlb } = await import('./glb.js');
    return [{ name, bytes: writeGlb(result) }];
  },
};

/** All files of a result in one format: one, or one for each sheet in formats of single sheets. */
export function writeFiles(format: ExportFormat, source: ExportSource): Promise<WrittenFile[]> {
  return writers[format](source);
}
