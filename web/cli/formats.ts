import { extname } from 'node:path';
import { writeFiles } from '../export/files.js';
import { exportFormats, type ExportFormat, type WrittenFile } from '../export/formats.js';
import type { Print } from '../export/print.js';
import type { JobResult } from '../model/job.js';
import type { Settings } from '../model/options.js';
import { pixelExcess } from '../model/pixels.js';
import { BadOption } from '../words/bad-option.js';
import { usageError } from './exit.js';
import type { OutputFile } from './write-files.js';

const endingOf = (path: string): string => extname(path).slice(1).toLowerCase();

/** By the ending of a file's name, if it is one that can be written. */
export function formatOf(path: string): ExportFormat | undefined {
  return exportFormats.find((format) => format === endingOf(path));
}

/** Those of all outputs. */
export function formatsOf(outputs: readonly string[]): ExportFormat[] {
  return outputs.flatMap((path) => formatOf(path) ?? []);
}

/** @throws Exit for a picture that would have too many pixels */
function checkPixels(path: string, { paper, dpi }: Settings): void {
  const excess = pixelExcess(paper.width, paper.height, dpi);
  if (excess !== null)
    throw usageError(({ command, optionFault }) =>
      command.aboutFile(path, optionFault({ what: 'pixels', ...excess })),
    );
}

/** @throws Exit for an output whose ending is no format, or that is too large to be drawn */
export function checkFormat(path: string, settings: Settings): void {
  const format = formatOf(path);
  if (format === 'png') checkPixels(path, settings);
  if (format !== undefined) return;
  const known = exportFormats.map((format) => `.${format}`).join(', ');
  const ending = extname(path).toLowerCase();
  throw usageError(({ command }) => command.ending(path, ending, known));
}

/** What outputs are made of. */
export interface OutputSource {
  result: JobResult;
  print: Print;
  /** The document as one file. */
  project: () => Promise<Uint8Array>;
}

async function writeOutput(path: string, source: OutputSource): Promise<WrittenFile[]> {
  const format = formatOf(path)!;
  if (format === 'foldwright') return [{ name: path, bytes: await source.project() }];
  try {
    return await writeFiles(format, { result: source.result, print: source.print, name: path });
  } catch (error) {
    // Edits may have chosen other sheets than the command line did.
    if (!(error instanceof BadOption)) throw error;
    const { params } = error;
    throw usageError(({ command, optionFault }) => command.aboutFile(path, optionFault(params)));
  }
}

/**
 * All files of all outputs, not yet written.
 * @throws Exit for one that cannot be
 */
export async function renderOutputs(
  outputs: string[],
  source: OutputSource,
): Promise<OutputFile[]> {
  const files: OutputFile[] = [];
  for (const path of outputs) {
    const written = await writeOutput(path, source);
    files.push(...written.map(({ name, bytes }) => ({ path: name, content: bytes })));
  }
  return files;
}
