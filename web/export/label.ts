/** A short text on a sheet; mm, y up, from the sheet's lower left. */
export interface Label {
  text: string;
  /** The middle of its box. */
  x: number;
  y: number;
  /** Of its baseline, counter-clockwise from the right; degrees. */
  angle: number;
  /** Of the font. */
  size: number;
}

// Capitals and digits of a sans-serif face.
const capHeight = 0.72;

/** Where a centred line of text begins to be written: the middle of its baseline. */
export function baselineOf({ x, y, angle, size }: Label): [x: number, y: number] {
  const drop = (size * capHeight) / 2;
  const turn = (angle * Math.PI) / 180;
  return [x + drop * Math.sin(turn), y - drop * Math.cos(turn)];
}
