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

/** The files that came along with a model, by how it names them, and which of them were used. */
export class Companions {
  /** Normalized and in lower case, as systems differ in what they tell apart. */
  private readonly byPath = new Map<string, string>();
  private readonly used = new Set<string>();

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
   * The file of an address that is relative to the model; where none lies there, one of that name beside the
   * model, since whoever picks files loses their folders. Null if it did not come along.
   */
  find(address: string): ModelFile | null {
    const folder = folderOf(this.model);
    for (const path of [address, decoded(address)]) {
      const name = path.replace(/^.*[/\\]/, '');
      for (const candidate of [folder + path, folder + name]) {
        const found = this.byPath.get(normalized(candidate)?.toLowerCase() ?? '');
        if (found === undefined) continue;
        this.used.add(found);
        return this.source.read(found);
      }
    }
    return null;
  }

  /** Paths of those that nothing was made of. */
  get unused(): string[] {
    return [...this.byPath.values()].filter((path) => !this.used.has(path));
  }
}
