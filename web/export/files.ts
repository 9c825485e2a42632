/** The one place that knows what writes each format. */
import type { JobResult } from '../model/job.js';
import type { ExportFormat, WrittenFile } from './formats.js';
import type { Print } from './print.js';
import { sheetName } from './sheet-name.js';

/** What files are made of. */
export interface ExportSource {
  result: JobResult;
  print: Print;
  /** Of the file, with its ending; those of several sheets are numbered. */
  name: string;
}

const utf8 = new TextEncoder();

/** A file for each sheet, numbered where there are several. */
async function eachSheet(
  { print, name }: ExportSource,
  write: (sheet: number) => Uint8Array | Promise<Uint8Array>,
): Promise<WrittenFile[]> {
  const files: WrittenFile[] = [];
  const count = print.sheets.length;
  for (let sheet = 0; sheet < count; ++sheet) {
    files.push({ name: sheetName(name, sheet, count), bytes: await write(sheet) });
  }
  return files;
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
    return eachSheet(source, (sheet) => utf8.encode(writeSvg(source.print, sheet)));
  },
  async dxf(source) {
    const { writeDxf } = await import('./dxf.js');
    return eachSheet(source, async (sheet) => utf8.encode(await writeDxf(source.print, sheet)));
  },
  async png(source) {
    const { writePng } = await import('./png.js');
    return eachSheet(source, (sheet) => writePng(source.print, sheet));
  },
  async pdf(source) {
    const { writePdf } = await import('./pdf.js');
    const { print, name } = source;
    if (print.machine === 'none') return [{ name, bytes: await writePdf(print) }];
    // A machine takes a file for each of its mats.
    return eachSheet(source, (sheet) => writePdf(print, [print.sheets[sheet]!]));
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
