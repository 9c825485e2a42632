import { extname } from 'node:path';
import type { JobResult } from '../model/job.js';
import { writeFold } from '../export/fold.js';
import { writeGlb } from '../export/glb.js';
import type { Print } from '../export/print.js';
import { sheetName } from '../export/sheet-name.js';
import { writeSvg } from '../export/svg.js';
import { usageError } from './exit.js';
import type { OutputFile } from './write-files.js';

type Renderer = (
  path: string,
  result: JobResult,
  print: Print,
) => OutputFile[] | Promise<OutputFile[]>;

function renderSvg(path: string, _result: JobResult, print: Print): OutputFile[] {
  const count = print.sheets.length;
  return print.sheets.map((_, sheet) => ({
    path: sheetName(path, sheet, count),
    content: writeSvg(print, sheet),
  }));
}

async function renderPdf(path: string, _result: JobResult, print: Print): Promise<OutputFile[]> {
  // Most of the program's size, and most runs do without.
  const { writePdf } = await import('../export/pdf.js');
  return [{ path, content: await writePdf(print) }];
}

const renderers: Record<string, Renderer> = {
  '.fold': (path, result) => [{ path, content: writeFold(result) }],
  '.svg': renderSvg,
  '.pdf': renderPdf,
  '.glb': (path, result) => [{ path, content: writeGlb(result) }],
};

const laterFormats = ['.dxf', '.png'];

function formatOf(path: string): string {
  return extname(path).toLowerCase();
}

/** @throws Exit for an output whose ending is no format */
export function checkFormat(path: string): void {
  const format = formatOf(path);
  if (format in renderers) return;
  if (laterFormats.includes(format)) {
    throw usageError(`'${path}': the format ${format} does not exist in this version yet`);
  }
  const known = Object.keys(renderers).join(', ');
  throw usageError(`'${path}': the ending '${format}' is none of ${known}`);
}

/** All files of all outputs, not yet written. */
export async function renderOutputs(
  outputs: string[],
  result: JobResult,
  print: Print,
): Promise<OutputFile[]> {
  const files: OutputFile[] = [];
  for (const path of outputs) {
    files.push(...(await renderers[formatOf(path)]!(path, result, print)));
  }
  return files;
}
