/** Widths of holes that are filled, in percent of the model's longest side. */

/** What may be asked for; none narrower would be seen, and what is wider is all. */
export const fillRange = { least: 0.1, most: 100 } as const;

/** Wider than any hole: the diagonal of a box is at most 173 % of its longest side. */
export const widestHole = 200;

/** What has to be asked for so that a hole is filled. */
export function fillingFor(percent: number): number | 'all' {
  return percent > fillRange.most ? 'all' : Math.max(percent, fillRange.least);
}
