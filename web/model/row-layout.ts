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

/** Rectangles that lie somewhere, by their numbers, and how much room they take from (0, 0) up. */
interface Layout extends Box {
  spots: Map<number, Spot>;
}

/** Row widths that are tried, evenly from that of the widest box to that of all in one row. */
const attempts = 32;

/** Lays boxes in this order in rows from the top down, the boxes of a row in its middle. */
function inRows(
  boxes: readonly Box[],
  order: readonly number[],
  rowWidth: number,
  gap: number,
): Layout {
  const rows: { numbers: number[]; width: number; height: number }[] = [];
  for (const number of order) {
    const { width, height } = boxes[number]!;
    const row = rows.at(-1);
    if (row && row.width + gap + width <= rowWidth) {
      row.numbers.push(number);
      row.width += gap + width;
      row.height = Math.max(row.height, height);
    } else {
      rows.push({ numbers: [number], width, height });
    }
  }
  const width = Math.max(...rows.map((row) => row.width));
  const height = rows.reduce((sum, row) => sum + row.height + gap, -gap);
  const spots = new Map<number, Spot>();
  let top = height;
  for (const row of rows) {
    let x = (width - row.width) / 2;
    for (const number of row.numbers) {
      spots.set(number, { x, y: top - boxes[number]!.height });
      x += boxes[number]!.width + gap;
    }
    top -= row.height + gap;
  }
  return { spots, width, height };
}

/** Lays a box to the left of a layout, both in the middle of the height. */
function leftOf(number: number, box: Box, layout: Layout, gap: number): Layout {
  const height = Math.max(box.height, layout.height);
  const spots = new Map([[number, { x: 0, y: (height - box.height) / 2 }]]);
  for (const [other, { x, y }] of layout.spots) {
    spots.set(other, { x: x + box.width + gap, y: y + (height - layout.height) / 2 });
  }
  return { spots, width: box.width + gap + layout.width, height };
}

/**
 * Lays rectangles in rows, tall ones first and the tallest perhaps beside all others, so that none
 * overlap and all together fill a view that is `aspect` times as wide as high; the middle of all is
 * at (0, 0).
 *
 * @param gap between neighbours
 */
export function layInRows(boxes: readonly Box[], aspect: number, gap: number): Spot[] {
  const byHeight = [...boxes.keys()].sort((a, b) => boxes[b]!.height - boxes[a]!.height || a - b);
  const [tallest, ...others] = byHeight;
  const widest = Math.max(...boxes.map(({ width }) => width));
  const all = boxes.reduce((sum, { width }) => sum + width + gap, 0);
  const layouts: Layout[] = [];
  for (let attempt = 0; attempt <= attempts; ++attempt) {
    const rowWidth = widest + ((all - widest) * attempt) / attempts;
    layouts.push(inRows(boxes, byHeight, rowWidth, gap));
    if (others.length === 0) continue;
    layouts.push(leftOf(tallest!, boxes[tallest!]!, inRows(boxes, others, rowWidth, gap), gap));
  }
  const room = ({ width, height }: Layout): number => Math.max(width / aspect, height);
  const best = layouts.reduce((a, b) => (room(b) < room(a) ? b : a));
  return boxes.map((_, number) => {
    const { x, y } = best.spots.get(number)!;
    return { x: x - best.width / 2, y: y - best.height / 2 };
  });
}
