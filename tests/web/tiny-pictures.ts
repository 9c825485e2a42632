/** The smallest pictures of some kinds, and beginnings of others, for tests of what is taken for a picture. */

const bytes = (...parts: (string | number[])[]): Uint8Array =>
  Uint8Array.from(
    parts.flatMap((part) =>
      typeof part === 'string' ? [...part].map((letter) => letter.charCodeAt(0)) : part,
    ),
  );

/** One red pixel. */
export const png = Uint8Array.from(
  atob(
    'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==',
  ),
  (letter) => letter.charCodeAt(0),
);

export const beginnings: Readonly<Record<string, Uint8Array>> = {
  PNG: png,
  JPEG: bytes([0xff, 0xd8, 0xff, 0xe0]),
  GIF: bytes('GIF89a', [1, 0, 1, 0]),
  WebP: bytes('RIFF', [9, 0, 0, 0], 'WEBPVP8 '),
  BMP: bytes('BM', [70, 0, 0, 0, 0, 0, 0, 0, 54]),
  TIFF: bytes('II*', [0, 8]),
  DDS: bytes('DDS ', [124]),
  KTX: bytes([0xab], 'KTX 20', [0xbb, 13, 10, 26, 10]),
  TGA: bytes([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0]),
  SVG: bytes('<svg xmlns="http://www.w3.org/2000/svg"/>'),
  '': bytes('no picture'),
};
