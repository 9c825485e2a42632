/** Kinds of pictures, by their contents. */

/** Kinds that can be shown and printed. */
const usable: readonly string[] = ['PNG', 'JPEG', 'GIF'];

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

/** TGA has no mark of its own: whether a table of colours follows, a kind of packing, no table or one from 0. */
function isTga([, table = 2, packing = 0, first = 1]: Uint8Array): boolean {
  return table <= 1 && [1, 2, 3, 9, 10, 11].includes(packing) && first === 0;
}

/** What people call the kind of a picture; an empty word for what is none that is known. */
export function pictureKind(bytes: Uint8Array): string {
  // Decoders of text make other letters of some bytes, and not everywhere the same.
  const begin = String.fromCharCode(...bytes.subarray(0, 64));
  const marked = beginnings.find(([, beginning]) => beginning.test(begin));
  return marked?.[0] ?? (isTga(bytes) ? 'TGA' : '');
}

/** Whether pictures of that kind can be shown and printed. */
export function isUsable(kind: string): boolean {
  return usable.includes(kind);
}
