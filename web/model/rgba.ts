/** Pixels in rows from above. */
export interface Rgba {
  width: number;
  height: number;
  /** 4 per pixel: red, green, blue, and how much of what is behind it covers; 0 to 255. */
  rgba: Uint8Array;
}

/** A value of few bits as one of eight. @param most the largest value of so many bits */
export function widened(value: number, most: number): number {
  return most === 255 ? value : Math.round((255 * value) / most);
}

/** Makes what can be seen of a picture that is transparent everywhere: programs that know of no transparency leave 0. */
export function opaqueIfEmpty(rgba: Uint8Array): void {
  for (let at = 3; at < rgba.length; at += 4) if (rgba[at] !== 0) return;
  for (let at = 3; at < rgba.length; at += 4) rgba[at] = 255;
}
