/** A box in place of a sign that no font has: left, bottom, right and top over the size of the font. */
export const missingBox = [0.06, 0, 0.66, 0.72] as const;

/** From the beginning of that box to the next sign, over the size of the font. */
export const missingWidth = 0.72;

/** Of the lines of the box, over the size of the font. */
export const missingLine = 0.06;
