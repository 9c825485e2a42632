/** A place in the window, and a box there; pixels. */
export interface WindowPoint {
  x: number;
  y: number;
}

export interface WindowBox {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** How large sheets and what is around them are. */
export interface Arrangement {
  count: number;
  /** Of the widest and the highest sheet, in mm. */
  width: number;
  height: number;
}

/** Pixels between sheets, and below each for its caption. */
export interface Gaps {
  between: number;
  caption: number;
}

/** Widths in pixels that the widest sheet can have on the screen. */
export const widthRange = { least: 40, most: 6000 } as const;

/** By how much one notch of a mouse wheel, which browsers count as 100 pixels, changes the size. */
const perNotch = 1.15;

/** Pixels of a line and of a page, for browsers that count in those. */
const modePixels = [1, 33, 400];

/** How many times as large the sheets get when a wheel is turned. */
export function wheelFactor({
  deltaY,
  deltaMode,
}: Pick<WheelEvent, 'deltaY' | 'deltaMode'>): number {
  const notches = (deltaY * (modePixels[deltaMode] ?? 1)) / 100;
  // Some mice tell several notches at once, and no one means a jump.
  return perNotch ** -Math.min(Math.max(notches, -3), 3);
}

export function clampedWidth(width: number): number {
  return Math.min(Math.max(width, widthRange.least), widthRange.most);
}

/** Where a place lies in a box, as shares of its width and height. */
export function shareAt(box: WindowBox, { x, y }: WindowPoint): WindowPoint {
  return { x: (x - box.left) / box.width, y: (y - box.top) / box.height };
}

/** How far what lies at a share of a box is from where it shall be: by so much its ground has to be scrolled. */
export function scrollTo(box: WindowBox, share: WindowPoint, wanted: WindowPoint): WindowPoint {
  return {
    x: box.left + share.x * box.width - wanted.x,
    y: box.top + share.y * box.height - wanted.y,
  };
}

/** Width in pixels of the widest sheet at which so many columns and rows of sheets fit into a room. */
function widthFor(
  { width, height }: Arrangement,
  grid: { columns: number; rows: number },
  room: { width: number; height: number; gaps: Gaps },
): number {
  const { between, caption } = room.gaps;
  const across = (room.width - between * (grid.columns - 1)) / grid.columns;
  const down = (room.height - between * (grid.rows - 1)) / grid.rows - caption;
  return Math.min(across, (down * width) / height);
}

/** The number of columns with which all sheets are seen as large as possible in a room, and how wide they are then. */
export function allInView(
  sheets: Arrangement,
  room: { width: number; height: number; gaps: Gaps },
): { columns: number; width: number } {
  let best = { columns: 1, width: 0 };
  for (let columns = 1; columns <= Math.max(sheets.count, 1); ++columns) {
    const width = widthFor(sheets, { columns, rows: Math.ceil(sheets.count / columns) }, room);
    if (width > best.width) best = { columns, width };
  }
  return { ...best, width: clampedWidth(best.width) };
}

/** Width at which one whole sheet is seen; by its width alone in a room of no height of its own. */
export function oneInView(
  sheets: Arrangement,
  room: { width: number; height: number | null; gaps: Gaps },
): number {
  const height = room.height ?? Infinity;
  return clampedWidth(widthFor(sheets, { columns: 1, rows: 1 }, { ...room, height }));
}
