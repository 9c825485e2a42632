import { writeFiles } from '../export/files.js';
import type { DrawnFormat } from '../export/formats.js';
import type { Print } from '../export/print.js';
import type { JobResult } from '../model/job.js';
import type { SheetRange } from '../model/sheet-range.js';

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
  /** The sheets that are wanted. */
  only: SheetRange;
}

const mediaTypes: Readonly<Record<DrawnFormat, string>> = {
  pdf: 'application/pdf',
  svg: 'image/svg+xml',
  dxf: 'image/vnd.dxf',
  png: 'image/png',
  fold: 'application/json',
  glb: 'model/gltf-binary',
};

/** Writes the result in a format as one file: several come as a zip archive. */
export async function exportResult(
  format: DrawnFormat,
  { result, name, print, only }: ExportInput,
): Promise<ExportedFile> {
  const files = await writeFiles(format, { result, print, only, name: `${name}.${format}` });
  const [file] = files;
  if (files.length === 1) {
    return { name: file!.name, content: file!.bytes, mediaType: mediaTypes[format] };
  }
  const { zipped } = await import('../export/zip.js');
  return { name: `${name}-${format}.zip`, content: zipped(files), mediaType: 'application/zip' };
}
