/** A cell of the grid has so many tolerances along each axis: few points lie near its walls. */
const cellSize = 8;

/** Numbers for points in space, of which those that lie together get the same. */
export class SamePlaces {
  /** Cells of a grid by a hash of where they are, each with the points in it. */
  private readonly cells = new Map<number, number[]>();
  private readonly points: number[] = [];

  /** @param tolerance how far apart points are taken for one, along each axis */
  constructor(private readonly tolerance: number) {}

  /** The number of a point, which is a new one where none lies near. */
  of(points: ArrayLike<number>, index: number): number {
    const point = [points[3 * index]!, points[3 * index + 1]!, points[3 * index + 2]!] as const;
    return this.near(point) ?? this.add(point);
  }

  private cellAt(x: number, y: number, z: number): number {
    const along = (value: number): number => Math.floor(value / (cellSize * this.tolerance));
    // Primes that scatter neighbours; cells of the same hash do no harm, as distances are looked at.
    return (
      Math.imul(along(x), 73_856_093) ^
      Math.imul(along(y), 19_349_663) ^
      Math.imul(along(z), 83_492_791)
    );
  }

  /** Looks into all cells that the surroundings of a point reach into: one, unless it lies near a wall. */
  private near([x, y, z]: readonly [number, number, number]): number | undefined {
    const { tolerance } = this;
    const looked = new Set<number>();
    for (let corner = 0; corner < 8; ++corner) {
      const [a, b, c] = [1, 2, 4].map((bit) => (corner & bit ? tolerance : -tolerance));
      const cell = this.cellAt(x + a!, y + b!, z + c!);
      if (looked.has(cell)) continue;
      looked.add(cell);
      const found = this.cells.get(cell)?.find((number) => this.isAt(number, [x, y, z]));
      if (found !== undefined) return found;
    }
    return undefined;
  }

  private isAt(number: number, point: readonly number[]): boolean {
    return point.every(
      (value, axis) => Math.abs(value - this.points[3 * number + axis]!) <= this.tolerance,
    );
  }

  private add(point: readonly [number, number, number]): number {
    const number = this.points.length / 3;
    this.points.push(...point);
    const cell = this.cellAt(...point);
    const others = this.cells.get(cell);
    if (others) others.push(number);
    else this.cells.set(cell, [number]);
    return number;
  }
}
