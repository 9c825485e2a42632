/** Colours in rows from above, without transparency. */
export interface Raster {
  width: number;
  height: number;
  /** 3 per pixel: red, green and blue, 0 to 255. */
  rgb: Uint8Array;
}

/** A raster of half the size, each pixel the mean of those that it takes the place of. */
export function halved({ width, height, rgb }: Raster): Raster {
  const half = { width: Math.max(1, width >> 1), height: Math.max(1, height >> 1) };
  const means = new Uint8Array(3 * half.width * half.height);
  let at = 0;
  for (let y = 0; y < half.height; ++y) {
    const upper = 3 * width * Math.floor((y * height) / half.height);
    const lower = height > 1 ? upper + 3 * width : upper;
    for (let x = 0; x < half.width; ++x) {
      const left = 3 * Math.floor((x * width) / half.width);
      const right = width > 1 ? left + 3 : left;
      for (let i = 0; i < 3; ++i) {
        const sum =
          rgb[upper + left + i]! +
          rgb[upper + right + i]! +
          rgb[lower + left + i]! +
          rgb[lower + right + i]!;
        means[at++] = (sum + 2) >> 2;
      }
    }
  }
  return { ...half, rgb: means };
}
