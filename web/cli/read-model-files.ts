import { readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { FileLimits, isHidden, type ModelFile } from '../model/model-files.js';
import { placesOf } from '../read/companions.js';
import { companionsOf } from '../read/named-files.js';
import { Exit, exitStatus, type Told } from './exit.js';
import { placeOnDisk } from './place-on-disk.js';

/** Why something on the disk cannot be read. */
export function reasonOf(error: unknown): Told {
  const { code, message } = error as NodeJS.ErrnoException;
  return ({ command }) => {
    if (code === 'ENOENT' || code === 'ENOTDIR') return command.noFile;
    if (code === 'EACCES' || code === 'EPERM') return command.notAllowed;
    return command.notRead(message);
  };
}

/** The model could not be read or used. */
export function modelError(model: string, told: Told): Exit {
  return new Exit(exitStatus.model, (words) => `${model}: ${told(words)}`, told);
}

/** A file that was found, but not read yet. */
export interface FoundFile {
  /** Its path within the model's folder. */
  name: string;
  path: string;
}

/**
 * The files of a folder and of the folders in it, by name; links to folders are not followed.
 *
 * @param isWanted whether a folder within it is looked into, by its path
 */
export function* filesIn(
  folder: string,
  prefix = '',
  isWanted: (path: string) => boolean = () => true,
): Generator<FoundFile> {
  const entries = readdirSync(folder, { withFileTypes: true });
  for (const entry of entries.sort((a, b) => (a.name < b.name ? -1 : 1))) {
    if (isHidden(entry.name)) continue;
    const [name, path] = [prefix + entry.name, join(folder, entry.name)];
    if (entry.isDirectory()) {
      if (isWanted(path)) yield* filesIn(path, `${name}/`, isWanted);
    } else if (statSync(path, { throwIfNoEntry: false })?.isFile()) yield { name, path };
  }
}

/** @throws Exit for a folder without files, or with more than belong to a model */
function readFolder(folder: string): ModelFile[] {
  const limits = new FileLimits();
  const found: FoundFile[] = [];
  for (const file of filesIn(folder)) {
    const excess = limits.add(statSync(file.path).size);
    if (excess !== null) throw modelError(folder, ({ command }) => command.folderTooLarge(excess));
    found.push(file);
  }
  if (found.length === 0) throw modelError(folder, ({ command }) => command.emptyFolder);
  return found.map(({ name, path }) => ({ name, bytes: readFileSync(path) }));
}

/** A model's file with those beside it that it names, as far as they are there. */
function withNamed(model: string, file: ModelFile): ModelFile[] {
  const limits = new FileLimits();
  const find = (address: string, base: string): ModelFile | null => {
    const name = placeOnDisk(dirname(model), placesOf(address, base, file.name));
    if (name === null) return null;
    const path = join(dirname(model), name);
    const excess = limits.add(statSync(path).size);
    if (excess !== null)
      throw modelError(model, ({ command }) => command.companionsTooLarge(excess));
    return { name, bytes: readFileSync(path) };
  };
  return [file, ...companionsOf(file, find)];
}

/**
 * The model's file with those that it names, or all files of its folder.
 * @throws Exit if there is none, or nothing in it
 */
export function readModelFiles(model: string): ModelFile[] {
  try {
    const status = statSync(model);
    if (status.isDirectory()) return readFolder(model);
    // Reading from a device might never end.
    if (!status.isFile() && !status.isFIFO())
      throw modelError(model, ({ command }) => command.notAFile);
    const bytes = readFileSync(model);
    if (bytes.length === 0) throw modelError(model, ({ command }) => command.emptyFile);
    return withNamed(model, { name: basename(model), bytes });
  } catch (error) {
    throw error instanceof Exit ? error : modelError(model, reasonOf(error));
  }
}
