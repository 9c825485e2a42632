import type { Grid } from './cover.js';

/** Stands for a column without colour above or below. */
const none = -1;

/** Per dot the row of the nearest one in its column that is covered. */
function nearestRows({ width, height }: Grid, covered: Uint8Array): Int16Array {
  const rows = new Int16Array(width * height);
  for (let column = 0; column < width; ++column) {
    let last = none;
    for (let row = 0; row < height; ++row) {
      const dot = row * width + column;
      if (covered[dot] === 1) last = row;
      rows[dot] = last;
    }
    last = none;
    for (let row = height - 1; row >= 0; --row) {
      const dot = row * width + column;
      if (covered[dot] === 1) last = row;
      const above = rows[dot]!;
      if (above === none || (last !== none && last - row < row - above)) rows[dot] = last;
    }
  }
  return rows;
}

/** Finds in one row after the other the nearest of all dots that are covered. */
class RowSearch {
  /** Columns whose dot is the nearest one for a stretch of the row, and where the stretches begin. */
  private readonly columns: Int32Array;
  private readonly starts: Float64Array;
  private count = 0;

  constructor(
    private readonly grid: Grid,
    private readonly rows: Int16Array,
  ) {
    this.columns = new Int32Array(grid.width);
    this.starts = new Float64Array(grid.width);
  }

  /** Square of the way from this row to the nearest dot of a column. */
  private depth(row: number, column: number): number {
    const way = this.rows[row * this.grid.width + column]! - row;
    return way * way;
  }

  /** The lower envelope of one parabola for each column (Felzenszwalb and Huttenlocher, 2012). */
  private envelope(row: number): void {
    const { columns, starts } = this;
    this.count = 0;
    for (let column = 0; column < this.grid.width; ++column) {
      if (this.rows[row * this.grid.width + column] === none) continue;
      const height = this.depth(row, column) + column * column;
      let start = -Infinity;
      while (this.count > 0) {
        const before = columns[this.count - 1]!;
        const heightBefore = this.depth(row, before) + before * before;
        start = (height - heightBefore) / (2 * (column - before));
        if (start > starts[this.count - 1]!) break;
        --this.count;
        start = -Infinity;
      }
      columns[this.count] = column;
      starts[this.count++] = start;
    }
  }

  /** Calls with each dot of a row, the nearest covered one, and the square of the way there, in dots. */
  search(row: number, found: (dot: number, nearest: number, square: number) => void): void {
    const { width } = this.grid;
    this.envelope(row);
    if (this.count === 0) return;
    for (let column = 0, i = 0; column < width; ++column) {
      while (i + 1 < this.count && this.starts[i + 1]! <= column) ++i;
      const from = this.columns[i]!;
      const nearest = this.rows[row * width + from]! * width + from;
      const way = column - from;
      found(row * width + column, nearest, way * way + this.depth(row, from));
    }
  }
}

/**
 * Gives dots beyond the faces the colour of the nearest covered one.
 *
 * @param rgba 4 per dot
 * @param covered per dot 1 if it has its colour, 2 if it shall have one
 * @param reach mm within which all others get one, too
 */
export function bleed(grid: Grid, rgba: Uint8Array, covered: Uint8Array, reach: number): void {
  const colours = new Uint32Array(rgba.buffer, rgba.byteOffset, grid.width * grid.height);
  const search = new RowSearch(grid, nearestRows(grid, covered));
  // From the middle of the nearest dot, which may lie almost a whole dot within the outline.
  const farthest = (reach * grid.density + 1) ** 2;
  for (let row = 0; row < grid.height; ++row) {
    search.search(row, (dot, nearest, square) => {
      if (covered[dot] === 1) return;
      if (covered[dot] === 2 || square <= farthest) colours[dot] = colours[nearest]!;
    });
  }
}
