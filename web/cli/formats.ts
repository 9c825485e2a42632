import { extname } from 'node:path';
import { writeFiles } from '../export/files.js';
import { exportFormats, type ExportFormat, type WrittenFile } from '../export/formats.js';
import type { Print } from '../export/print.js';
import type { JobResult } from '../model/job.js';
import type { Settings } from '../model/options.js';
import { pixelExcess } from '../model/pixels.js';
import { BadOption } from '../words/bad-option.js';
import { optionWords } from '../words/en-options.js';
import { usageError } from './exit.js';
import type { OutputFile } from './write-files.js';

const endingOf = (path: string): string => extname(path).slice(1).toLowerCase();

/** By the ending of a file's name, if it is one that can be written. */
export function formatOf(path: string): ExportFormat | undefined {
  return exportFormats.find((format) => format === endingOf(path));
}

/** @throws Exit for a picture that would have too many pixels */
function checkPixels(path: string, { paper, dpi }: Settings): void {
  const excess = pixelExcess(paper.width, paper.height, dpi);
  if (excess !== null) throw usageError(`'${path}': ${optionWords({ what: 'pixels', ...excess })}`);
}

/** @throws Exit for an output whose ending is no format, or that is too large to be drawn */
export function checkFormat(path: string, settings: Settings): void {
  const format = formatOf(path);
  if (format === 'png') checkPixels(path, settings);
  if (format !== undefined) return;
  const known = exportFormats.map((format) => `.${format}`).join(', ');
  throw usageError(`'${path}': the ending '${extname(path).toLowerCase()}' is none of ${known}`);
}

async function writeOutput(path: string, result: JobResult, print: Print): Promise<WrittenFile[]> {
  try {
    return await writeFiles(formatOf(path)!, { result, print, name: path });
  } catch (error) {
    // Edits may have chosen other sheets than the command line did.
    throw error instanceof BadOption ? usageError(`'${path}': ${error.message}`) : error;
  }
}

/**
 * All files of all outputs, not yet written.
 * @throws Exit for one that cannot be
 */
export async function renderOutputs(
  outputs: string[],
  result: JobResult,
  print: Print,
): Promise<OutputFile[]> {
  const files: OutputFile[] = [];
  for (const path of outputs) {
    const written = await writeOutput(path, result, print);
    files.push(...written.map(({ name, bytes }) => ({ path: name, content: bytes })));
  }
  return files;
}
