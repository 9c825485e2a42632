/** The pictures of a glTF file: inside it, beside it, or written into its addresses. */
import type { GLTF } from '@gltf-transform/core';
import type { Wrap } from '../../model/looks.js';
import type { ModelFile } from '../../model/model-files.js';
import type { Companions } from '../companions.js';
import { decoded } from '../paths.js';
import type { Pictures } from '../pictures.js';
import { bytesOfData, isData } from './buffers.js';
import type { Container } from './container.js';

const wraps: Readonly<Record<number, Wrap>> = { 33071: 'clamp', 33648: 'mirror' };

/** Other kinds of pictures, which a file may have beside one that everyone reads, or alone. */
const otherSources = [
  'EXT_texture_webp',
  'EXT_texture_avif',
  'KHR_texture_basisu',
  'MSFT_texture_dds',
];

function sourceOf({ source, extensions }: GLTF.ITexture): number | undefined {
  const others = otherSources.map((name) => extensions?.[name] as { source?: number } | undefined);
  return source ?? others.find((other) => other?.source !== undefined)?.source;
}

/** Finds the pictures of textures. */
export class Images {
  constructor(
    private readonly container: Container,
    private readonly companions: Companions,
    private readonly pictures: Pictures,
  ) {}

  /** Number of a texture's picture; null for one that there is not, or that cannot be used. */
  pictureOf(texture: number): number | null {
    const { textures = [], images = [] } = this.container.json;
    const index = sourceOf(textures[texture] ?? {});
    const image = index === undefined ? undefined : images[index];
    if (!image) return null;
    const name = this.nameOf(image, index!);
    return this.pictures.add(String(index), name, () => this.fileOf(image, name));
  }

  /** What a texture does beyond the edges of its picture. */
  wrapOf(texture: number): readonly [Wrap, Wrap] {
    const { textures = [], samplers = [] } = this.container.json;
    const { wrapS = 0, wrapT = 0 } = samplers[textures[texture]?.sampler ?? -1] ?? {};
    return [wraps[wrapS] ?? 'repeat', wraps[wrapT] ?? 'repeat'];
  }

  private nameOf({ uri, name }: GLTF.IImage, index: number): string {
    if (uri !== undefined && !isData(uri)) return decoded(uri);
    return name || `picture ${index + 1}`;
  }

  private fileOf({ uri, bufferView }: GLTF.IImage, name: string): ModelFile | null {
    if (bufferView !== undefined) return { name, bytes: this.bytesOfView(bufferView) };
    if (uri === undefined) return null;
    return isData(uri) ? { name, bytes: bytesOfData(uri) } : this.companions.find(uri);
  }

  /** A copy, so that the rest of its buffer is not held; short or empty where there is less. */
  private bytesOfView(index: number): Uint8Array {
    const { json, binary } = this.container;
    const { buffer, byteOffset = 0, byteLength = 0 } = json.bufferViews?.[index] ?? { buffer: -1 };
    const uri = json.buffers?.[buffer]?.uri;
    const inside = buffer === 0 && uri === undefined ? binary : null;
    const bytes = uri === undefined ? inside : this.bytesNamed(uri);
    return bytes?.slice(byteOffset, byteOffset + byteLength) ?? new Uint8Array();
  }

  private bytesNamed(uri: string): Uint8Array | null {
    return isData(uri) ? bytesOfData(uri) : (this.companions.find(uri)?.bytes ?? null);
  }
}
