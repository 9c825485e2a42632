/**
 * Hatches that tell parts apart without colour. Each is drawn in a square tile that repeats; lines
 * run past the edges of the tile, so that they join those of its neighbours.
 */

/** Side of the tile. */
export const hatchTile = 8;

/** Width of the lines, in the measure of the tile. */
export const hatchWidth = 1;

/** SVG path data, one for each hatch; the first is plain. Neighbours in the list differ most. */
export const hatchPaths = [
  '',
  'M-2 10 10-2M-2 2 2-2M6 10 10 6',
  'M-1 4H9',
  'M-2-2 10 10M-2 6 2 10M6-2 10 2',
  'M4-1V9',
  'M-1 4H9M4-1V9',
  'M3 4H5M-1 0H1M7 0H9M-1 8H1M7 8H9',
] as const;

/** Index of the hatch of a part; parts seven apart share one, and differ in tint. */
export function partHatch(part: number): number {
  return part % hatchPaths.length;
}
