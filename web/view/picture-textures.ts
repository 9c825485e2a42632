import {
  CanvasTexture,
  ClampToEdgeWrapping,
  MirroredRepeatWrapping,
  RepeatWrapping,
  SRGBColorSpace,
  type Texture,
  type Wrapping,
} from 'three';
import { readBmp } from '../model/bmp.js';
import { isTooLarge, pictureHeader } from '../model/picture-header.js';
import { readTga } from '../model/tga.js';
import type { Material, Wrap } from '../model/looks.js';
import type { ModelFile } from '../model/model-files.js';
import { newContext } from './context-2d.js';

/** Pixels of all pictures together: four bytes each, and a third more for smaller copies. */
const mostPixels = 2 ** 26;

/** Pixels along the longer side of a picture; more is not seen on a screen. */
const longestSide = 4096;

const wrappings: Readonly<Record<Wrap, Wrapping>> = {
  repeat: RepeatWrapping,
  mirror: MirroredRepeatWrapping,
  clamp: ClampToEdgeWrapping,
};

/** A decoded picture, by the same means as for print where browsers read a kind each in its own way, or not at all. */
function bitmapOf(bytes: Uint8Array<ArrayBuffer>): Promise<ImageBitmap> {
  const header = pictureHeader(bytes);
  const isOurs = header && !isTooLarge(header) && (header.kind === 'bmp' || header.kind === 'tga');
  if (!isOurs) return createImageBitmap(new Blob([bytes]));
  const pixels = header.kind === 'bmp' ? readBmp(bytes) : readTga(bytes);
  if (!pixels) throw new Error('the picture is damaged');
  const { width, height, rgba } = pixels;
  const clamped = new Uint8ClampedArray(rgba.buffer as ArrayBuffer);
  return createImageBitmap(new ImageData(clamped, width, height));
}

/** A picture on white, as paper has it, with no side longer than that; null for one that is damaged. */
async function canvasOf({ bytes }: ModelFile, longest: number): Promise<HTMLCanvasElement | null> {
  try {
    const bitmap = await bitmapOf(bytes as Uint8Array<ArrayBuffer>);
    const share = Math.min(1, longest / Math.max(bitmap.width, bitmap.height));
    const [width, height] = [bitmap.width, bitmap.height].map((side) => Math.ceil(share * side));
    const context = newContext(width!, height!);
    context.fillStyle = 'white';
    context.fillRect(0, 0, width!, height!);
    context.drawImage(bitmap, 0, 0, width!, height!);
    bitmap.close();
    // The library draws from both kinds of canvases, and declares one.
    return context.canvas as HTMLCanvasElement;
  } catch {
    return null;
  }
}

/** The pictures of a model for the graphics card, decoded once. */
export class PictureTextures {
  private readonly canvases: Promise<HTMLCanvasElement | null>[];
  private readonly textures: Texture[] = [];

  constructor(pictures: readonly ModelFile[]) {
    const longest = Math.min(longestSide, Math.floor(Math.sqrt(mostPixels / pictures.length)));
    // One after the other: each takes its memory several times while it is decoded.
    let last: Promise<unknown> = Promise.resolve();
    this.canvases = pictures.map((picture) => {
      const canvas = last.then(() => canvasOf(picture, longest));
      last = canvas;
      return canvas;
    });
  }

  /** The picture of a material; null for one without, or whose picture is damaged. */
  async of({ picture, wrap }: Material): Promise<Texture | null> {
    const canvas = picture === null ? null : await this.canvases[picture];
    if (!canvas) return null;
    const texture = new CanvasTexture(canvas);
    texture.colorSpace = SRGBColorSpace;
    texture.wrapS = wrappings[wrap[0]];
    texture.wrapT = wrappings[wrap[1]];
    this.textures.push(texture);
    return texture;
  }

  dispose(): void {
    for (const texture of this.textures) texture.dispose();
  }
}
