import {
  FileLimits,
  probableModel,
  type ModelFile,
  type ModelFiles,
} from '../model/model-files.js';
import type { Words } from '../words/words.js';
import type { ReadProject } from '../project/project.js';
import type { FoldedNets } from '../read/fold/folded-nets.js';
import { fetchNamed } from './fetch-named.js';

/** A project as this browser has kept it. */
export interface Kept {
  id: string;
  name: string;
  /** Counts what was saved: who has seen less than there is must not write over it. */
  revision: number;
}

/** A model as it was chosen. */
export interface ChosenModel {
  /** Of its file; by the endings of names until the engine has read it. */
  name: string;
  files: ModelFiles;
  /** Names of files that were chosen after it, and belong to it; absent if there are none. */
  added?: readonly string[];
  /** The document that the files came in; absent where they are only a model. */
  project?: ReadProject;
  /** The nets that the file brings along to be looked at; absent where it has none, or is only a model. */
  exhibit?: FoldedNets;
  /** Where this browser keeps it, if it came from there. */
  kept?: Kept;
}

/** A file that was picked, and where it lay in the folder that was picked with it. */
export interface PickedFile {
  path: string;
  file: File;
}

/** A choice that gives no model; `tell` has a sentence for the person who chose. */
export class UnusableChoice extends Error {
  constructor(readonly tell: (words: Words) => string) {
    super();
  }
}

function checkSizes(picked: readonly PickedFile[]): void {
  const limits = new FileLimits();
  for (const { file } of picked) {
    const excess = limits.add(file.size);
    if (excess === null) continue;
    throw new UnusableChoice(({ choice }) =>
      picked.length === 1 ? choice.fileTooLarge(file.name, excess) : choice.tooMuch(excess),
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

/** Whether an address is one of another site, which must allow this one to fetch its files, as must the page. */
function isElsewhere(address: string, base: string): boolean {
  return URL.canParse(address, base) && new URL(address, base).origin !== location.origin;
}

/**
 * Fetches a model from an address, which may be relative to `base`, and the files that it names from beside it. Throws
 * UnusableChoice for one that is not there, empty or too large.
 */
export async function fetchModelFile(
  address: string,
  base: string,
  signal: AbortSignal,
): Promise<ChosenModel> {
  const name = fileNameOf(address);
  const unloaded = (): never => {
    const words = isElsewhere(address, base) ? 'notLetIn' : 'notLoaded';
    throw new UnusableChoice(({ choice }) => choice[words](name));
  };
  let bytes: Blob;
  try {
    const response = await fetch(new URL(address, base), { signal });
    if (!response.ok) throw new Error(response.statusText);
    bytes = await response.blob();
  } catch {
    return unloaded();
  }
  const { files, ...chosen } = await readModelFiles([
    { path: name, file: new File([bytes], name) },
  ]);
  const named = await fetchNamed(files[0]!, new URL(address, base), signal).catch(unloaded);
  return { ...chosen, files: [...files, ...named] };
}

async function readFile({ path, file }: PickedFile): Promise<ModelFile> {
  const bytes = await file.arrayBuffer().catch(() => {
    throw new UnusableChoice(({ choice }) => choice.unreadable(path));
  });
  return { name: path, bytes: new Uint8Array(bytes) };
}

/**
 * Reads the files of a choice. Throws UnusableChoice for none, for a single one that is empty, and for what is
 * unreadable or too large.
 */
export async function readModelFiles(picked: readonly PickedFile[]): Promise<ChosenModel> {
  if (picked.length === 0) {
    throw new UnusableChoice(({ choice }) => choice.noFile);
  }
  checkSizes(picked);
  const files = await Promise.all(picked.map(readFile));
  const name = probableModel(files);
  if (files.every(({ bytes }) => bytes.length === 0)) {
    throw new UnusableChoice(({ choice }) => choice.empty(name));
  }
  return { name, files };
}
