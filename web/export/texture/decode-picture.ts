import { renderSvg } from '../renderer.js';
import { base64 } from './base64.js';
import { readBmp } from '../../model/bmp.js';
import {
  isTooLarge,
  pictureHeader,
  type PictureHeader,
  type PictureKind,
} from '../../model/picture-header.js';
import type { Rgba } from '../../model/rgba.js';
import { readTga } from '../../model/tga.js';
import { readWebp } from './webp.js';
import type { Raster } from './raster.js';

/** Why a picture is not decoded. */
export type PictureFault = 'format' | 'damaged' | 'large';

/** More than so many pixels without compression. */
const mostBytes = 2 ** 28;

/** The picture alone, pixel by pixel. */
function drawingOf({ kind, width, height }: PictureHeader, bytes: Uint8Array): string {
  const size = `width="${width}" height="${height}"`;
  const image = `<image ${size} image-rendering="optimizeSpeed" href="data:image/${kind};base64,${base64(bytes)}"/>`;
  return `<svg xmlns="http://www.w3.org/2000/svg" ${size}>${image}</svg>`;
}

/** Pixels before white, of colours that are multiplied by what they cover, as the renderer has them. */
function beforeWhite(rgba: Uint8Array): Uint8Array {
  const rgb = new Uint8Array((rgba.length / 4) * 3);
  for (let from = 0, to = 0; from < rgba.length; from += 4) {
    const white = 255 - rgba[from + 3]!;
    rgb[to++] = rgba[from]! + white;
    rgb[to++] = rgba[from + 1]! + white;
    rgb[to++] = rgba[from + 2]! + white;
  }
  return rgb;
}

/** The same of colours that are not multiplied by anything. */
function laidOnWhite({ width, height, rgba }: Rgba): Raster {
  const rgb = new Uint8Array(3 * width * height);
  for (let from = 0, to = 0; from < rgba.length; ++from) {
    const cover = rgba[from | 3]!;
    if (from % 4 < 3) rgb[to++] = Math.round(255 + ((rgba[from]! - 255) * cover) / 255);
  }
  return { width, height, rgb };
}

/** What a picture's header says, or why it is not decoded. */
export function checkPicture(bytes: Uint8Array): PictureHeader | PictureFault {
  const header = pictureHeader(bytes);
  if (!header) return 'format';
  const { width, height } = header;
  if (width === 0 || height === 0) return 'damaged';
  return isTooLarge(header) || bytes.length > mostBytes ? 'large' : header;
}

/** The renderer leaves out what it cannot read. */
function rendered(header: PictureHeader, bytes: Uint8Array): Raster | null {
  const { width, height } = header;
  const rgba = renderSvg(drawingOf(header, bytes), undefined, ({ pixels }) => pixels);
  if (rgba.every((value) => value === 0)) return null;
  return { width, height, rgb: beforeWhite(rgba) };
}

/** Of kinds that the renderer does not know. */
const readers: Readonly<
  Partial<Record<PictureKind, (bytes: Uint8Array) => Rgba | null | Promise<Rgba>>>
> = { bmp: readBmp, tga: readTga, webp: readWebp };

/**
 * Decodes a picture with the renderer or the decoder of WebP, which must have been started, or by itself: the same
 * pixels in node and in browsers. Of animations the first picture; what is transparent gets white behind it.
 *
 * @returns null for a picture that is damaged, or of which nothing can be seen
 */
export async function decodePicture(
  header: PictureHeader,
  bytes: Uint8Array,
): Promise<Raster | null> {
  try {
    const reader = readers[header.kind];
    if (!reader) return rendered(header, bytes);
    const pixels = await reader(bytes);
    return pixels && laidOnWhite(pixels);
  } catch {
    return null;
  }
}
