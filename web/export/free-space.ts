import type { Area } from '../model/sheet-room.js';
import type { Point } from './point.js';

// Side of a cell; mm.
const cell = 1;

/** Keeps, for every cell of a sheet, how many cells left of and below it are taken. */
export class FreeSpace {
  private readonly columns: number;
  private readonly rows: number;
  private readonly sums: Int32Array;

  /**
   * @param area where there may be free space
   * @param shapes closed walks around what takes space, by the even-odd rule
   * @param gap what stays free around them; mm
   */
  constructor(
    private readonly area: Area,
    shapes: readonly Point[][],
    gap: number,
  ) {
    this.columns = Math.max(0, Math.floor((area.right - area.left) / cell));
    this.rows = Math.max(0, Math.floor((area.top - area.bottom) / cell));
    const taken = new Uint8Array(this.columns * this.rows);
    const sides = shapes.flatMap((walk) =>
      walk.map((from, i): [Point, Point] => [from, walk[(i + 1) % walk.length]!]),
    );
    this.fill(taken, sides);
    for (const [from, to] of sides) this.line(taken, from, to, gap);
    this.sums = this.add(taken);
  }

  /** The lowest place for a box of this size, and of these the rightmost; null if there is none. */
  place(width: number, height: number): Point | null {
    const [across, up] = [Math.ceil(width / cell), Math.ceil(height / cell)];
    for (let row = 0; row + up <= this.rows; ++row) {
      for (let column = this.columns - across; column >= 0; --column) {
        if (this.taken(column, row, column + across, row + up) === 0) {
          return [this.area.left + column * cell, this.area.bottom + row * cell];
        }
      }
    }
    return null;
  }

  private column(x: number): number {
    return Math.floor((x - this.area.left) / cell);
  }

  private row(y: number): number {
    return Math.floor((y - this.area.bottom) / cell);
  }

  /** Cells whose middle lies inside. */
  private fill(taken: Uint8Array, sides: readonly [Point, Point][]): void {
    for (let row = 0; row < this.rows; ++row) {
      const y = this.area.bottom + (row + 0.5) * cell;
      const crossings = sides
        .filter(([[, ay], [, by]]) => ay > y !== by > y)
        .map(([[ax, ay], [bx, by]]) => ax + ((y - ay) / (by - ay)) * (bx - ax))
        .sort((a, b) => a - b);
      for (let i = 0; i + 1 < crossings.length; i += 2) {
        this.mark(taken, row, crossings[i]!, crossings[i + 1]!);
      }
    }
  }

  /** Cells near a line: those of boxes along it. */
  private line(taken: Uint8Array, [ax, ay]: Point, [bx, by]: Point, gap: number): void {
    const steps = Math.max(1, Math.ceil(Math.hypot(bx - ax, by - ay) / cell));
    for (let i = 0; i <= steps; ++i) {
      const [x, y] = [ax + ((bx - ax) * i) / steps, ay + ((by - ay) * i) / steps];
      for (let row = this.row(y - gap); row <= this.row(y + gap); ++row) {
        this.mark(taken, row, x - gap, x + gap);
      }
    }
  }

  private mark(taken: Uint8Array, row: number, from: number, to: number): void {
    if (row < 0 || row >= this.rows) return;
    const first = Math.max(0, this.column(from));
    const last = Math.min(this.columns - 1, this.column(to));
    if (first <= last) taken.fill(1, row * this.columns + first, row * this.columns + last + 1);
  }

  private add(taken: Uint8Array): Int32Array {
    const width = this.columns + 1;
    const sums = new Int32Array(width * (this.rows + 1));
    for (let row = 0; row < this.rows; ++row) {
      let sum = 0;
      for (let column = 0; column < this.columns; ++column) {
        sum += taken[row * this.columns + column]!;
        const below = sums[row * width + column + 1]!;
        sums[(row + 1) * width + column + 1] = below + sum;
      }
    }
    return sums;
  }

  private taken(left: number, bottom: number, right: number, top: number): number {
    const at = (column: number, row: number): number =>
      this.sums[row * (this.columns + 1) + column]!;
    return at(right, top) - at(left, top) - at(right, bottom) + at(left, bottom);
  }
}
