/** Numbers for points in space, of which those that lie together get the same. */
export class SamePlaces {
  /** Cells of a grid, each with the points in it. */
  private readonly cells = new Map<string, number[]>();
  private readonly points: number[] = [];

  /** @param tolerance how far apart points are taken for one, along each axis */
  constructor(private readonly tolerance: number) {}

  /** The number of a point, which is a new one where none lies near. */
  of(points: ArrayLike<number>, index: number): number {
    const point = [points[3 * index]!, points[3 * index + 1]!, points[3 * index + 2]!] as const;
    const cell = point.map((value) => Math.floor(value / this.tolerance));
    return this.near(point, cell) ?? this.add(point, cell);
  }

  private near(point: readonly number[], [i, j, k]: readonly number[]): number | undefined {
    for (let at = 0; at < 27; ++at) {
      const [x, y, z] = [(at % 3) - 1, (Math.floor(at / 3) % 3) - 1, Math.floor(at / 9) - 1];
      const found = this.cells.get(`${i! + x} ${j! + y} ${k! + z}`)?.find((number) =>
        point.every((value, axis) => {
          return Math.abs(value - this.points[3 * number + axis]!) <= this.tolerance;
        }),
      );
      if (found !== undefined) return found;
    }
    return undefined;
  }

  private add(point: readonly number[], cell: readonly number[]): number {
    const number = this.points.length / 3;
    this.points.push(...point);
    const key = cell.join(' ');
    const others = this.cells.get(key);
    if (others) others.push(number);
    else this.cells.set(key, [number]);
    return number;
  }
}
