import type { ModelFile, ModelFiles } from '../model/model-files.js';
import { decoded, folderOf, normalized } from './paths.js';

/** Files that are there to be read. */
export interface FileSource {
  readonly paths: readonly string[];
  read(path: string): ModelFile;
}

/** Files that are read already. */
export function sourceOf(files: ModelFiles): FileSource {
  const byName = new Map(files.map((file) => [file.name, file]));
  return { paths: [...byName.keys()], read: (path) => byName.get(path)! };
}

const nameIn = (address: string): string => address.replace(/^.*[/\\]/, '');

/**
 * Where the file of an address may lie: there, or under its name beside the file that names it or beside the model,
 * since whoever picks or moves files loses their folders. Normalized paths, the first one first; none leads out.
 *
 * @param base path of the file that names it
 * @param model path of the model
 */
export function placesOf(address: string, base: string, model: string): string[] {
  const paths = [address, decoded(address)];
  const places = [base, model].flatMap((from) =>
    [...paths, ...paths.map(nameIn)].flatMap((path) => normalized(folderOf(from) + path) || []),
  );
  return [...new Set(places)];
}

/** The files that came along with a model, by how it names them, and which of them were used. */
export class Companions {
  /** Normalized and in lower case, as systems differ in what they tell apart. */
  private readonly byPath = new Map<string, string>();
  private readonly read = new Map<string, ModelFile>();

  /** @param model path of the model, which other paths are relative to */
  constructor(
    private readonly source: FileSource,
    private readonly model: string,
  ) {
    for (const path of source.paths) {
      const key = normalized(path)?.toLowerCase();
      if (key !== undefined && path !== model) this.byPath.set(key, path);
    }
  }

  /**
   * The file of an address; null if it did not come along.
   *
   * @param base path of the file that names it, and to which it is relative
   */
  find(address: string, base = this.model): ModelFile | null {
    const found = this.pathOf(address, base);
    if (found === undefined) return null;
    const file = this.read.get(found) ?? this.source.read(found);
    this.read.set(found, file);
    return file;
  }

  /** Where no file lies at an address, the only one of that name is taken, in whatever folder. */
  private pathOf(address: string, base: string): string | undefined {
    for (const path of placesOf(address, base, this.model)) {
      const found = this.byPath.get(path.toLowerCase());
      if (found !== undefined) return found;
    }
    const called = this.named(nameIn(address));
    return called.length === 1 ? called[0] : undefined;
  }

  /** Paths of all files of that name, in whatever folders. */
  private named(name: string): string[] {
    const end = `/${name.toLowerCase()}`;
    const found = [...this.byPath].filter(([key]) => `/${key}`.endsWith(end));
    return found.map(([, path]) => path);
  }

  /** Paths of all of them. */
  get paths(): string[] {
    return [...this.byPath.values()];
  }

  /** Whether a file was found by some address. */
  isUsed(path: string): boolean {
    return this.read.has(path);
  }

  /** Paths of those that nothing was made of. */
  get unused(): string[] {
    return this.paths.filter((path) => !this.isUsed(path));
  }
}
