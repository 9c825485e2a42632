/** What the first bytes of a picture's file say of it. */

import { bmpHeader } from './bmp.js';
import { tgaHeader } from './tga.js';

/** Kinds of pictures that are decoded. */
export type PictureKind = 'png' | 'jpeg' | 'gif' | 'webp' | 'bmp' | 'tga';

export interface PictureHeader {
  kind: PictureKind;
  /** Pixels. */
  width: number;
  height: number;
}

/** No screen card takes longer sides, so no picture for a model has them. */
const longestSide = 16_384;

/** Of one picture: while it is decoded it takes about twelve bytes for each pixel, and browsers give a few GB. */
export const mostPixels = 2 ** 26;

/** Whether a picture has more pixels than are decoded. */
export function isTooLarge({ width, height }: Pick<PictureHeader, 'width' | 'height'>): boolean {
  return Math.max(width, height) > longestSide || width * height > mostPixels;
}

function starts(bytes: Uint8Array, with_: readonly number[]): boolean {
  return with_.every((byte, i) => bytes[i] === byte);
}

const pngSignature = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
const jpegSignature = [0xff, 0xd8, 0xff];
const gifSignature = [0x47, 0x49, 0x46, 0x38];

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

function pngHeader(bytes: Uint8Array): PictureHeader | null {
  if (bytes.length < 24) return null;
  const view = viewOf(bytes);
  return { kind: 'png', width: view.getUint32(16), height: view.getUint32(20) };
}

function gifHeader(bytes: Uint8Array): PictureHeader | null {
  if (bytes.length < 10) return null;
  const view = viewOf(bytes);
  return { kind: 'gif', width: view.getUint16(6, true), height: view.getUint16(8, true) };
}

/** Whether a marker begins a frame; three of that range begin tables. */
function isFrame(marker: number): boolean {
  return marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker);
}

/** Segment by segment, each with its length, to the one that begins the frame. */
function jpegHeader(bytes: Uint8Array): PictureHeader | null {
  const view = viewOf(bytes);
  let at = 2;
  while (at + 9 <= bytes.length) {
    // Any number of these bytes may stand before a marker.
    if (bytes[at] !== 0xff) return null;
    const marker = bytes[at + 1]!;
    if (marker === 0xff) {
      at += 1;
    } else if (isFrame(marker)) {
      return { kind: 'jpeg', height: view.getUint16(at + 5), width: view.getUint16(at + 7) };
    } else {
      at += 2 + view.getUint16(at + 2);
    }
  }
  return null;
}

/** Size of a picture in one of the three forms that WebP has: with losses, without, and with more than pixels. */
function webpHeader(bytes: Uint8Array): PictureHeader | null {
  if (bytes.length < 30) return null;
  const view = viewOf(bytes);
  const u24 = (at: number): number => view.getUint16(at, true) | (view.getUint8(at + 2) << 16);
  const form = String.fromCharCode(...bytes.subarray(12, 16));
  if (form === 'VP8X') return { kind: 'webp', width: u24(24) + 1, height: u24(27) + 1 };
  if (form === 'VP8L') {
    const bits = view.getUint32(21, true);
    return { kind: 'webp', width: (bits & 0x3fff) + 1, height: ((bits >>> 14) & 0x3fff) + 1 };
  }
  if (form !== 'VP8 ') return null;
  const [width, height] = [26, 28].map((at) => view.getUint16(at, true) & 0x3fff);
  return { kind: 'webp', width: width!, height: height! };
}

function isWebp(bytes: Uint8Array): boolean {
  return (
    String.fromCharCode(...bytes.subarray(0, 12)).replace(/(?<=^RIFF)[^]{4}/, '') === 'RIFFWEBP'
  );
}

/** Kind and size of a picture; null if it is none of these kinds, or ends before it says its size. */
export function pictureHeader(bytes: Uint8Array): PictureHeader | null {
  if (starts(bytes, pngSignature)) return pngHeader(bytes);
  if (starts(bytes, jpegSignature)) return jpegHeader(bytes);
  if (starts(bytes, gifSignature)) return gifHeader(bytes);
  if (isWebp(bytes)) return webpHeader(bytes);
  const bmp = bmpHeader(bytes);
  if (bmp) return { kind: 'bmp', width: bmp.width, height: bmp.height };
  const tga = tgaHeader(bytes);
  return tga && { kind: 'tga', width: tga.width, height: tga.height };
}
