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

/**
 * Cosine and sine of a text's angle, to a millionth: the functions' last digits differ between
 * browsers, and files do not.
 */
export function directionOf({ angle }: Label): [cosine: number, sine: number] {
  const turn = (angle * Math.PI) / 180;
  return [Math.round(1e6 * Math.cos(turn)) / 1e6, Math.round(1e6 * Math.sin(turn)) / 1e6];
}

/** Where a centred line of text begins to be written: the middle of its baseline. */
export function baselineOf(label: Label): [x: number, y: number] {
  const drop = (label.size * capHeight) / 2;
  const [cosine, sine] = directionOf(label);
  return [label.x + drop * sine, label.y - drop * cosine];
}
