/** The one place that knows what writes each format. */
import type { JobResult } from '../model/job.js';
import type { ExportFormat, WrittenFile } from './formats.js';
import type { Print } from './print.js';

/** What files are made of. */
export interface ExportSource {
  result: JobResult;
  print: Print;
  /** Of the file, with its ending; those of several sheets are numbered. */
  name: string;
}

const utf8 = new TextEncoder();

type Writer = (source: ExportSource) => Promise<WrittenFile[]>;

// Each loads when it is first asked for: the PDF writer is larger than all else.
const writers: Readonly<Record<ExportFormat, Writer>> = {
  async fold({ result, name }) {
    const { writeFold } = await import('./fold.js');
    return [{ name, bytes: utf8.encode(writeFold(result)) }];
  },
  async svg({ print, name }) {
    const { svgFiles } = await import('./svg-files.js');
    return svgFiles(print, name).map((file) => ({
      name: file.name,
      bytes: utf8.encode(file.text),
    }));
  },
  async pdf({ print, name }) {
    const { writePdf } = await import('./pdf.js');
    return [{ name, bytes: await writePdf(print) }];
  },
  async glb({ result, name }) {
    const { writeGlb } = await import('./glb.js');
    return [{ name, bytes: writeGlb(result) }];
  },
};

/** All files of a result in one format: one for each sheet as SVG, else one. */
export function writeFiles(format: ExportFormat, source: ExportSource): Promise<WrittenFile[]> {
  return writers[format](source);
}
