import { extname } from 'node:path';
import { writeFiles } from '../export/files.js';
import { exportFormats, type ExportFormat } from '../export/formats.js';
import type { Print } from '../export/print.js';
import type { JobResult } from '../model/job.js';
import { usageError } from './exit.js';
import type { OutputFile } from './write-files.js';

const laterFormats = ['png'];

const endingOf = (path: string): string => extname(path).slice(1).toLowerCase();

function formatOf(path: string): ExportFormat | undefined {
  return exportFormats.find((format) => format === endingOf(path));
}

/** @throws Exit for an output whose ending is no format */
export function checkFormat(path: string): void {
  if (formatOf(path) !== undefined) return;
  const ending = endingOf(path);
  if (laterFormats.includes(ending)) {
    throw usageError(`'${path}': the format .${ending} does not exist in this version yet`);
  }
  const known = exportFormats.map((format) => `.${format}`).join(', ');
  throw usageError(`'${path}': the ending '${extname(path).toLowerCase()}' is none of ${known}`);
}

/** All files of all outputs, not yet written. */
export async function renderOutputs(
  outputs: string[],
  result: JobResult,
  print: Print,
): Promise<OutputFile[]> {
  const files: OutputFile[] = [];
  for (const path of outputs) {
    const written = await writeFiles(formatOf(path)!, { result, print, name: path });
    files.push(...written.map(({ name, bytes }) => ({ path: name, content: bytes })));
  }
  return files;
}
