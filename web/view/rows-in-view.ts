import { layInRows, type Box, type Spot } from '../model/row-layout.js';

/** CSS pixels that stay free around all. */
const margin = 10;

export interface RowsInView {
  /** Of the lower left corners, from the middle of the view, y up; in units of the boxes. */
  spots: readonly Spot[];
  /** CSS pixels to the unit. */
  scale: number;
}

/**
 * Rectangles in rows, as large as they go into a view of this many CSS pixels.
 *
 * @param gap between neighbours, in units of the boxes
 */
export function rowsInView(
  boxes: readonly Box[],
  width: number,
  height: number,
  gap: number,
): RowsInView {
  const [across, up] = [width - 2 * margin, height - 2 * margin];
  const spots = layInRows(boxes, across / up, gap);
  const reach = (side: (i: number) => number): number => Math.max(...boxes.map((_, i) => side(i)));
  const scale = Math.min(
    across / (2 * reach((i) => spots[i]!.x + boxes[i]!.width)),
    up / (2 * reach((i) => spots[i]!.y + boxes[i]!.height)),
  );
  return { spots, scale };
}
