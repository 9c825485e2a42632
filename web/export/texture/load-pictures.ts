import type { Notice } from '../../model/job.js';
import type { Looks } from '../../model/looks.js';
import type { ModelFile } from '../../model/model-files.js';
import { startRenderer } from '../renderer.js';
import type { RendererLoader } from '../renderer-loader.js';
import { pictureHeader } from '../../model/picture-header.js';
import { checkPicture, decodePicture, type PictureFault } from './decode-picture.js';
import type { Raster } from './raster.js';
import { startWebp } from './webp.js';

/** Of all pictures together: three bytes each, and a third more for smaller copies. */
const mostPixels = 2 ** 27;

export interface LoadedPictures {
  /** By number; null for those that are not used or not to be had. */
  pictures: (Raster | null)[];
  notices: Notice[];
}

/** Numbers of the pictures of which faces show something. */
function usedPictures({ materials, surface }: Looks): Set<number> {
  const used = new Set<number>();
  if (!surface.places || !surface.materials) return used;
  for (const material of new Set(surface.materials)) {
    const picture = materials[material]?.picture ?? null;
    if (picture !== null) used.add(picture);
  }
  return used;
}

/** Decodes pictures one after the other, as long as they are not too many. */
class Decoding {
  private pixels = 0;
  private readonly faults = new Map<PictureFault, string[]>();

  async decode({ name, bytes }: ModelFile): Promise<Raster | null> {
    const found = await this.tryToDecode(bytes);
    if (typeof found !== 'string') return found;
    this.faults.set(found, [...(this.faults.get(found) ?? []), name]);
    return null;
  }

  get notices(): Notice[] {
    return [...this.faults].map(([what, files]) => ({
      code: 'pictures-unreadable',
      params: { what, files },
    }));
  }

  private async tryToDecode(bytes: Uint8Array): Promise<Raster | PictureFault> {
    const header = checkPicture(bytes);
    if (typeof header === 'string') return header;
    this.pixels += header.width * header.height;
    if (this.pixels > mostPixels) return 'large';
    return (await decodePicture(header, bytes)) ?? 'damaged';
  }
}

function isSame(one: ModelFile | null, other: ModelFile | null | undefined): boolean {
  if (!one || !other) return one === other;
  if (one.name !== other.name || one.bytes.length !== other.bytes.length) return false;
  return one.bytes.every((byte, i) => byte === other.bytes[i]);
}

function areSame(some: readonly (ModelFile | null)[], others: typeof some): boolean {
  return some.length === others.length && some.every((one, i) => isSame(one, others[i]));
}

/**
 * Those that were decoded last: every edit of a model gives a new result with the same pictures, and to compare
 * them takes less than to decode them.
 */
let last: { files: readonly (ModelFile | null)[]; loaded: LoadedPictures } | null = null;

async function startDecoders(
  files: readonly (ModelFile | null)[],
  loadRenderer: RendererLoader,
): Promise<void> {
  await startRenderer(loadRenderer);
  // Few models have pictures of that kind.
  const hasWebp = files.some((file) => file && pictureHeader(file.bytes)?.kind === 'webp');
  if (hasWebp) await startWebp(loadRenderer);
}

/** Decodes the pictures that faces show. Those that cannot be had are told in the notices. */
export async function loadPictures(
  looks: Looks,
  loadRenderer: RendererLoader,
): Promise<LoadedPictures> {
  const used = usedPictures(looks);
  const files = looks.pictures.map((file, i) => (used.has(i) ? file : null));
  const none = files.map(() => null);
  if (used.size === 0) return { pictures: none, notices: [] };
  if (last && areSame(files, last.files)) return last.loaded;
  try {
    await startDecoders(files, loadRenderer);
  } catch {
    // Sheets in plain colours are better than none.
    return { pictures: none, notices: [{ code: 'pictures-not-loaded', params: {} }] };
  }
  const decoding = new Decoding();
  const pictures: (Raster | null)[] = [];
  for (const file of files) pictures.push(file && (await decoding.decode(file)));
  last = { files, loaded: { pictures, notices: decoding.notices } };
  return last.loaded;
}
