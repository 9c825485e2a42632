import { writeSvg } from '../export/svg.js';
import type { Print } from '../export/print.js';
import type { JobResult } from '../model/job.js';

/** A file for the person to keep. */
export interface ExportedFile {
  name: string;
  content: string | Uint8Array;
  mediaType: string;
}

export interface ExportInput {
  result: JobResult;
  /** Name of the model without its ending. */
  name: string;
  /** The sheets as they were drawn last. */
  print: Print;
}

type Exporter = (input: ExportInput) => Promise<ExportedFile>;

// The others load when they are first asked for: a PDF writer is larger than the whole page.
const exporters: Readonly<Record<string, Exporter>> = {
  pdf: async ({ print, name }) => {
    const { writePdf } = await import('../export/pdf.js');
    const content = await writePdf(print);
    return { name: `${name}.pdf`, content, mediaType: 'application/pdf' };
  },
  svg: async ({ print, name }) => {
    if (print.sheets.length === 1) {
      return { name: `${name}.svg`, content: writeSvg(print, 0), mediaType: 'image/svg+xml' };
    }
    const { writeSvgZip } = await import('../export/svg-zip.js');
    const content = writeSvgZip(print, `${name}.svg`);
    return { name: `${name}-svg.zip`, content, mediaType: 'application/zip' };
  },
  fold: async ({ result, name }) => {
    const { writeFold } = await import('../export/fold.js');
    return { name: `${name}.fold`, content: writeFold(result), mediaType: 'application/json' };
  },
  glb: async ({ result, name }) => {
    const { writeGlb } = await import('../export/glb.js');
    return { name: `${name}.glb`, content: writeGlb(result), mediaType: 'model/gltf-binary' };
  },
};

/** Writes the result in a format: pdf, svg, fold or glb. */
export function exportResult(format: string, input: ExportInput): Promise<ExportedFile> {
  const exporter = exporters[format];
  if (!exporter) throw new Error(`No exporter writes ${format}`);
  return exporter(input);
}
