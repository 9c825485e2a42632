/** How many pixels a sheet has as a picture. */

/**
 * A4 at 1200 dots per inch has 139 million. Drawing takes nine bytes for each, and more than a few
 * GB no browser gives.
 */
export const mostPixels = 150_000_000;

export interface PixelSize {
  width: number;
  height: number;
}

/** Whole pixels that cover a sheet of so many mm. */
export function pixelSize(width: number, height: number, dpi: number): PixelSize {
  // Sheets come with the last digit of a sum: a millionth of a pixel is none.
  const cover = (length: number): number => Math.ceil((length * dpi) / 25.4 - 1e-6);
  return { width: cover(width), height: cover(height) };
}

/** A resolution that is too high for a sheet, and the highest that is not. */
export type PixelExcess = { dpi: number; width_mm: number; height_mm: number; possible: number };

/** What is wrong with a resolution for a sheet of so many mm; null if it can be drawn. */
export function pixelExcess(width: number, height: number, dpi: number): PixelExcess | null {
  const size = pixelSize(width, height, dpi);
  if (size.width * size.height <= mostPixels) return null;
  const possible = Math.floor(25.4 * Math.sqrt(mostPixels / (width * height)));
  return { dpi, width_mm: width, height_mm: height, possible };
}
