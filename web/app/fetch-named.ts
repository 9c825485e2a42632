/** Files that a fetched model names, such as its materials: they are fetched from beside it. */
import { FileLimits, type ModelFile } from '../model/model-files.js';
import { placesOf } from '../read/companions.js';
import { companionsOf } from '../read/named-files.js';
import { decoded } from '../read/paths.js';

/** A path from the folder of the model as an address; glTF files have such paths encoded already. */
function addressOf(path: string, model: URL): URL {
  return new URL(decoded(path).split('/').map(encodeURIComponent).join('/'), model);
}

/** Fetches files from the folder of a model, and from none outside of it. */
class Folder {
  private readonly limits = new FileLimits();
  /** By their paths; null for those that are not there, or too large. */
  private readonly fetched = new Map<string, ModelFile | null>();

  constructor(
    private readonly model: URL,
    private readonly signal: AbortSignal,
  ) {}

  /** The file of a path as far as it was fetched; undefined if nobody has tried. */
  known(path: string): ModelFile | null | undefined {
    return this.fetched.get(path);
  }

  async fetch(path: string): Promise<void> {
    this.fetched.set(path, await this.read(path));
  }

  private async read(path: string): Promise<ModelFile | null> {
    try {
      const response = await fetch(addressOf(path, this.model), { signal: this.signal });
      if (!response.ok) return null;
      const bytes = await response.blob();
      if (this.limits.add(bytes.size) !== null) return null;
      return { name: path, bytes: new Uint8Array(await bytes.arrayBuffer()) };
    } catch {
      this.signal.throwIfAborted();
      return null;
    }
  }
}

/**
 * The files that a model names, and those that these name, as far as they are there: whoever reads the model tells
 * what is missing. Each is asked for once. Rejects only when the signal is aborted.
 *
 * @param address of the model
 */
export async function fetchNamed(
  model: ModelFile,
  address: URL,
  signal: AbortSignal,
): Promise<ModelFile[]> {
  const folder = new Folder(address, signal);
  for (;;) {
    const wanted = new Set<string>();
    const found = companionsOf(model, (name, base) => {
      // A server is asked for one place only: what is not there counts as an error in the console of the page.
      const [place] = placesOf(name, base, model.name);
      if (place === undefined) return null;
      const file = folder.known(place);
      if (file === undefined) wanted.add(place);
      return file ?? null;
    });
    if (wanted.size === 0) return found;
    await Promise.all([...wanted].map((place) => folder.fetch(place)));
  }
}
