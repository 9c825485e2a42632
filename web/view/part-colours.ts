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

/** Colour of a part as a CSS colour; after 21 parts the colours come around again. */
export function partColour(part: number): string {
  const hue = hues[part % hues.length]!;
  const tint = tints[Math.floor(part / hues.length) % tints.length]!;
  const channels = hue.map((value) => Math.round(value + (255 - value) * tint));
  return `rgb(${channels.join(' ')})`;
}
