/** The palette of Okabe and Ito, which people with any colour vision tell apart. */
const hues = [
  [86, 180, 233],
  [230, 159, 0],
  [0, 158, 115],
  [204, 121, 167],
  [240, 228, 66],
  [0, 114, 178],
  [213, 94, 0],
] as const;

/** Shares of white: pale enough for thin lines on top, and apart from each other. */
const tints = [0.5, 0.72, 0.36] as const;

/** Red, green and blue of a part, 0 to 255; after 21 parts the colours come around again. */
export function partRgb(part: number): number[] {
  const hue = hues[part % hues.length]!;
  const tint = tints[Math.floor(part / hues.length) % tints.length]!;
  return hue.map((value) => Math.round(value + (255 - value) * tint));
}

/** Colour of a part as a CSS colour. */
export function partColour(part: number): string {
  return `rgb(${partRgb(part).join(' ')})`;
}
