import {
  FileLimits,
  probableModel,
  type ModelFile,
  type ModelFiles,
} from '../model/model-files.js';

/** A model as it was chosen. */
export interface ChosenModel {
  /** Of its file; by the endings of names until the engine has read it. */
  name: string;
  files: ModelFiles;
  /** Names of files that were chosen after it, and belong to it; absent if there are none. */
  added?: readonly string[];
}

/** A file that was picked, and where it lay in the folder that was picked with it. */
export interface PickedFile {
  path: string;
  file: File;
}

/** A choice that gives no model; the message is a sentence for the person who chose. */
export class UnusableChoice extends Error {}

function checkSizes(picked: readonly PickedFile[]): void {
  const limits = new FileLimits();
  for (const { file } of picked) {
    const excess = limits.add(file.size);
    if (excess === null) continue;
    throw new UnusableChoice(
      picked.length === 1
        ? `“${file.name}” is too large: it has ${excess}. Save it with fewer faces, or in a binary format.`
        : `That is too much: it has ${excess}. Choose a model and what belongs to it.`,
    );
  }
}

/** The part of an address that names the file. */
function fileNameOf(address: string): string {
  const last =
    address
      .replace(/[?#].*$/, '')
      .split('/')
      .at(-1) ?? '';
  try {
    return decodeURIComponent(last);
  } catch {
    // A percent sign of its own.
    return last;
  }
}

/**
 * Fetches a model from an address, which may be relative to `base`. Throws UnusableChoice for one that is not
 * there, empty or too large.
 */
export async function fetchModelFile(
  address: string,
  base: string,
  signal: AbortSignal,
): Promise<ChosenModel> {
  const name = fileNameOf(address);
  let bytes: Blob;
  try {
    const response = await fetch(new URL(address, base), { signal });
    if (!response.ok) throw new Error(response.statusText);
    bytes = await response.blob();
  } catch {
    throw new UnusableChoice(`“${name}” cannot be loaded.`);
  }
  return readModelFiles([{ path: name, file: new File([bytes], name) }]);
}

async function readFile({ path, file }: PickedFile): Promise<ModelFile> {
  const bytes = await file.arrayBuffer().catch(() => {
    throw new UnusableChoice(
      `“${path}” cannot be read: it is a folder, or it was moved, or may not be opened.`,
    );
  });
  return { name: path, bytes: new Uint8Array(bytes) };
}

/**
 * Reads the files of a choice. Throws UnusableChoice for none, for a single one that is empty, and for what is
 * unreadable or too large.
 */
export async function readModelFiles(picked: readonly PickedFile[]): Promise<ChosenModel> {
  if (picked.length === 0) {
    throw new UnusableChoice(
      'That was no file. Choose a GLB, OBJ, STL, 3MF, PLY, OFF or PDO file, or a ZIP with one.',
    );
  }
  checkSizes(picked);
  const files = await Promise.all(picked.map(readFile));
  const name = probableModel(files);
  if (files.every(({ bytes }) => bytes.length === 0)) {
    throw new UnusableChoice(`“${name}” is empty: there is nothing in it to unfold.`);
  }
  return { name, files };
}
