/** Puts the files of a model into its folder: all of them at once, or none. */
import { mkdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import type { WrittenFile } from '../../export/formats.js';

/** Where a folder is filled, and where the one before it goes meanwhile: beside it, as only there a rename is one step. */
function namesBeside(folder: string): { filling: string; old: string } {
  const beside = (word: string): string => join(dirname(folder), `.${basename(folder)}.${word}`);
  return { filling: beside('part'), old: beside('old') };
}

/** Removes what a batch that was killed has left beside a model's folder. */
export function tidyBeside(folder: string): void {
  const { filling, old } = namesBeside(folder);
  for (const path of [filling, old]) rmSync(path, { recursive: true, force: true });
}

/**
 * Makes a folder with just these files. Whenever the program is killed, the folder is as it was before, gone, or
 * complete. Without a pause, so that no signal comes between.
 */
export function writeFolder(folder: string, files: readonly WrittenFile[]): void {
  const { filling, old } = namesBeside(folder);
  tidyBeside(folder);
  mkdirSync(filling, { recursive: true });
  for (const { name, bytes } of files) writeFileSync(join(filling, name), bytes);
  try {
    renameSync(folder, old);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'ENOENT') throw error;
  }
  renameSync(filling, folder);
  rmSync(old, { recursive: true, force: true });
}
