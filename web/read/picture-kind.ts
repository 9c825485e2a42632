/** Kinds of pictures, by their contents. */

/** Kinds that can be shown and printed. */
const usable: readonly string[] = ['PNG', 'JPEG', 'WebP', 'GIF'];

/** How files of each kind begin; dots stand for any byte. */
const beginnings: readonly (readonly [string, RegExp])[] = [
  ['PNG', /^\x89PNG\r\n\x1a\n/],
  ['JPEG', /^\xff\xd8\xff/],
  ['WebP', /^RIFF[^]{4}WEBP/],
  ['GIF', /^GIF8[79]a/],
  ['BMP', /^BM[^]{4}\0\0\0\0/],
  ['TIFF', /^(?:II\*\0|MM\0\*)/],
  ['DDS', /^DDS /],
  ['KTX', /^\xabKTX [12][01]\xbb/],
  ['PSD', /^8BPS/],
  ['EXR', /^v\/1\x01/],
  ['HDR', /^#\?R/],
  ['AVIF', /^[^]{4}ftypavi[fs]/],
  ['HEIC', /^[^]{4}ftyp(?:hei|mif)/],
  ['SVG', /^(?:\xef\xbb\xbf)?\s*<(?:\?xml|!--|svg)/],
  // Without a mark of its own: a kind of colours, a kind of packing, and zeros where an origin is given.
  ['TGA', /^[^][\0\x01][\x01-\x03\x09-\x0b][^]{5}\0\0\0\0/],
];

const latin = new TextDecoder('latin1');

/** What people call the kind of a picture; an empty word for what is none that is known. */
export function pictureKind(bytes: Uint8Array): string {
  const begin = latin.decode(bytes.subarray(0, 64));
  return beginnings.find(([, beginning]) => beginning.test(begin))?.[0] ?? '';
}

/** Whether pictures of that kind can be shown and printed. */
export function isUsable(kind: string): boolean {
  return usable.includes(kind);
}
