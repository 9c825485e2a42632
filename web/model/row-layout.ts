/** A rectangle on a plane. */
export interface Box {
  width: number;
  height: number;
}

/** Where its lower left corner lies. */
export interface Spot {
  x: number;
  y: number;
}

/**
 * Lays rectangles in rows, tall ones first, so that none overlap, and all together are about
 * `aspect` times as wide as high; the middle of all is at (0, 0).
 *
 * @param gap between neighbours
 */
export function layInRows(boxes: readonly Box[], aspect: number, gap: number): Spot[] {
  const area = boxes.reduce((sum, { width, height }) => sum + (width + gap) * (height + gap), 0);
  const widest = Math.max(...boxes.map(({ width }) => width));
  const rowWidth = Math.max(widest, Math.sqrt(area * aspect));
  const spots: Spot[] = [];
  const size = { width: 0, height: 0 };
  let [x, y, rowHeight] = [0, 0, 0];
  const byHeight = [...boxes.keys()].sort((a, b) => boxes[b]!.height - boxes[a]!.height || a - b);
  for (const index of byHeight) {
    const { width, height } = boxes[index]!;
    if (x > 0 && x + width > rowWidth) {
      [x, y, rowHeight] = [0, y + rowHeight + gap, 0];
    }
    spots[index] = { x, y };
    x += width + gap;
    rowHeight = Math.max(rowHeight, height);
    size.width = Math.max(size.width, x - gap);
    size.height = y + rowHeight;
  }
  // The first row on top, as one reads.
  return spots.map((spot, index) => ({
    x: spot.x - size.width / 2,
    y: size.height / 2 - spot.y - boxes[index]!.height,
  }));
}
