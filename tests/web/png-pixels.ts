/** Decodes PNG files with a library that the project itself does not use. */
import UPNG from '@pdf-lib/upng';

/** Pixels in rows from above, 4 values each. */
export interface Pixels {
  width: number;
  height: number;
  rgba: Uint8Array;
}

// Node hands the library over as it is, vitest what the library calls its default.
const library = 'default' in UPNG ? (UPNG.default as typeof UPNG) : UPNG;

export function pngPixels(bytes: Uint8Array): Pixels {
  const decoded = library.decode(bytes.slice().buffer);
  const [rgba] = library.toRGBA8(decoded);
  return { width: decoded.width, height: decoded.height, rgba: new Uint8Array(rgba!) };
}
