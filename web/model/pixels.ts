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

/** What is wrong with a resolution for a sheet; null if it can be drawn. */
export function pixelExcess(width: number, height: number, dpi: number): string | null {
  const size = pixelSize(width, height, dpi);
  if (size.width * size.height <= mostPixels) return null;
  const most = Math.floor(25.4 * Math.sqrt(mostPixels / (width * height)));
  const sheet = `${Number(width.toFixed(1))} x ${Number(height.toFixed(1))} mm`;
  return `${dpi} dots per inch are too many for sheets of ${sheet}: ${most} are possible`;
}
