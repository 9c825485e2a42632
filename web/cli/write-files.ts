import { closeSync, openSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { usageError } from './exit.js';

export interface OutputFile {
  path: string;
  content: string | Uint8Array;
}

/** In the same folder, because only there a rename happens at once. */
function temporaryName(path: string): string {
  return join(dirname(path), `.${basename(path)}.${process.pid}.part`);
}

function reasonOf(error: unknown): string {
  switch ((error as NodeJS.ErrnoException).code) {
    case 'ENOENT':
      return 'does not exist';
    case 'ENOTDIR':
      return 'is not a directory';
    default:
      return `cannot be written to (${(error as NodeJS.ErrnoException).code})`;
  }
}

/**
 * Finds out before any work whether a file can be written, by making one beside it.
 * @throws Exit if it cannot
 */
export function checkWritable(path: string): void {
  const probe = temporaryName(path);
  try {
    closeSync(openSync(probe, 'wx'));
    rmSync(probe);
  } catch (error) {
    throw usageError(`'${path}': the directory '${dirname(path)}' ${reasonOf(error)}`);
  }
  if (statSync(path, { throwIfNoEntry: false })?.isDirectory()) {
    throw usageError(`'${path}' is a directory`);
  }
}

/**
 * Writes all files, each under another name first: a file appears only when it is complete, and
 * none appears if any cannot be written. Without a pause, so that no signal comes between.
 */
export function writeFiles(files: OutputFile[]): void {
  const temporary = files.map(({ path }) => temporaryName(path));
  try {
    files.forEach(({ content }, i) => writeFileSync(temporary[i]!, content));
    files.forEach(({ path }, i) => renameSync(temporary[i]!, path));
  } finally {
    for (const path of temporary) rmSync(path, { force: true });
  }
}
