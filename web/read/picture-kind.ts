/** Kinds of pictures, by their contents. */
import { tgaHeader } from '../model/tga.js';

/** Kinds that can be shown and printed. */
const usable: readonly string[] = ['PNG', 'JPEG', 'GIF', 'WebP', 'BMP', 'TGA'];

/** How files of each kind begin. */
const beginnings: readonly (readonly [string, RegExp])[] = [
  ['PNG', /^\x89PNG\r\n/],
  ['JPEG', /^\xff\xd8\xff/],
  ['GIF', /^GIF8[79]a/],
  ['WebP', /^RIFF[^]{4}WEBP/],
  ['BMP', /^BM[^]{4}\0\0\0\0/],
  ['TIFF', /^(?:II\*\0|MM\0\*)/],
  ['DDS', /^DDS /],
  ['KTX', /^\xabKTX [12][01]\xbb/],
  ['PSD', /^8BPS/],
  ['HDR', /^#\?R/],
  ['AVIF', /^[^]{4}ftypavi[fs]/],
  ['HEIC', /^[^]{4}ftyp(?:hei|mif)/],
  ['SVG', /^(?:\xef\xbb\xbf)?\s*<(?:\?xml|!--|svg)/],
];

/** What people call the kind of a picture; an empty word for what is none that is known. */
export function pictureKind(bytes: Uint8Array): string {
  // Decoders of text make other letters of some bytes, and not everywhere the same.
  const begin = String.fromCharCode(...bytes.subarray(0, 64));
  const marked = beginnings.find(([, beginning]) => beginning.test(begin));
  if (marked) return marked[0];
  // This kind has no mark.
  return tgaHeader(bytes) ? 'TGA' : '';
}

/** Whether pictures of that kind can be shown and printed. */
export function isUsable(kind: string): boolean {
  return usable.includes(kind);
}
