import UPNG from '@pdf-lib/upng';

/** A part of a picture, in pixels. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** How many colours a part of a PNG file has. */
export function coloursIn(png: Uint8Array, { x, y, width, height }: Box): number {
  const picture = UPNG.decode(Uint8Array.from(png).buffer);
  const pixels = new Uint32Array(UPNG.toRGBA8(picture)[0]!);
  const [left, top] = [Math.ceil(x), Math.ceil(y)];
  const colours = new Set<number>();
  for (let row = top; row < Math.min(y + height, picture.height); ++row) {
    const first = row * picture.width + left;
    for (const colour of pixels.subarray(first, first + Math.floor(width))) colours.add(colour);
  }
  return colours.size;
}
