import { closeSync, openSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { usageError, type Exit } from './exit.js';

export interface OutputFile {
  path: string;
  content: string | Uint8Array;
}

/** In the same folder, because only there a rename happens at once. */
function temporaryName(path: string): string {
  return join(dirname(path), `.${basename(path)}.${process.pid}.part`);
}

function obstacleOf(path: string, error: unknown): Exit {
  const folder = dirname(path);
  const { code } = error as NodeJS.ErrnoException;
  return usageError(({ command }) => {
    if (code === 'ENOENT') return command.noFolder(path, folder);
    if (code === 'ENOTDIR') return command.notAFolder(path, folder);
    return command.notWritable(path, folder, String(code));
  });
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
    throw obstacleOf(path, error);
  }
  if (statSync(path, { throwIfNoEntry: false })?.isDirectory()) {
    throw usageError(({ command }) => command.isFolder(path));
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
