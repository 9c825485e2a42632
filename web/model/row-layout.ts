/** A rectangle on a plane. */
export interface Box {
  width: number;
  height: number;
}

/** Where the lower left corner of a rectangle lies. */
export interface Spot {
  x: number;
  y: number;
}

/** Boxes beside each other. */
interface Row extends Box {
  boxes: number[];
}

/** Row widths that are tried, evenly from that of the widest box to that of all in one row. */
const attempts = 32;

/** Fills rows up to a width with boxes, tall ones first. */
function fillRows(boxes: readonly Box[], rowWidth: number, gap: number): Row[] {
  const byHeight = [...boxes.keys()].sort((a, b) => boxes[b]!.height - boxes[a]!.height || a - b);
  const rows: Row[] = [];
  for (const index of byHeight) {
    const { width, height } = boxes[index]!;
    const row = rows.at(-1);
    if (row && row.width + gap + width <= rowWidth) {
      row.boxes.push(index);
      row.width += gap + width;
    } else {
      rows.push({ boxes: [index], width, height });
    }
  }
  return rows;
}

function sizeOf(rows: readonly Row[], gap: number): Box {
  return {
    width: Math.max(...rows.map(({ width }) => width)),
    height: rows.reduce((sum, { height }) => sum + height + gap, -gap),
  };
}

/**
 * Lays rectangles in rows, tall ones first, so that none overlap and all together fill a view that
 * is `aspect` times as wide as high; the middle of all is at (0, 0).
 *
 * @param gap between neighbours
 */
export function layInRows(boxes: readonly Box[], aspect: number, gap: number): Spot[] {
  const widest = Math.max(...boxes.map(({ width }) => width));
  const all = boxes.reduce((sum, { width }) => sum + width + gap, -gap);
  let [best, least] = [[] as Row[], Infinity];
  for (let attempt = 0; attempt <= attempts; ++attempt) {
    // A little more than the sum, which rounding may have made too short.
    const width = widest + ((all * 1.001 - widest) * attempt) / attempts;
    const rows = fillRows(boxes, width, gap);
    const size = sizeOf(rows, gap);
    const needed = Math.max(size.width / aspect, size.height);
    if (needed < least) [best, least] = [rows, needed];
  }
  const spots: Spot[] = [];
  // The first row on top, as one reads.
  let top = sizeOf(best, gap).height / 2;
  for (const row of best) {
    let left = -row.width / 2;
    for (const index of row.boxes) {
      spots[index] = { x: left, y: top - boxes[index]!.height };
      left += boxes[index]!.width + gap;
    }
    top -= row.height + gap;
  }
  return spots;
}
