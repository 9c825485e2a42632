import type { Point } from '../point.js';

/** Dots in rows from above, where they lie on a sheet. */
export interface Grid {
  width: number;
  height: number;
  /** Of the first dot's upper left corner: mm from the sheet's lower left. */
  left: number;
  top: number;
  /** Dots to the mm. */
  density: number;
}

/** A place on the sheet in dots, from the grid's upper left. */
export function dotAt({ left, top, density }: Grid, [x, y]: Point): Point {
  return [density * (x - left), density * (top - y)];
}

/** Called with the number of a dot and the shares of the second and third corner there. */
export type Visit = (dot: number, b: number, c: number) => void;

/** The whole numbers from the first to the last one whose dot has its middle in a range. */
function range(values: readonly number[], size: number): [first: number, last: number] {
  const first = Math.ceil(Math.min(...values) - 0.5);
  const last = Math.floor(Math.max(...values) - 0.5);
  return [Math.max(0, first), Math.min(size - 1, last)];
}

// Whatever lies on an edge counts as inside, on both sides of it: no dot is missed between two faces.
const tolerance = 1e-9;

/** Visits all dots whose middles lie in a triangle on the sheet, row by row. */
export function coverTriangle(
  grid: Grid,
  corners: readonly [Point, Point, Point],
  visit: Visit,
): void {
  const [[x0, y0], [x1, y1], [x2, y2]] = corners.map((corner) => dotAt(grid, corner)) as [
    Point,
    Point,
    Point,
  ];
  const area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
  if (area === 0) return;
  const [firstRow, lastRow] = range([y0, y1, y2], grid.height);
  const [firstColumn, lastColumn] = range([x0, x1, x2], grid.width);
  const [bStep, cStep] = [(y2 - y0) / area, -(y1 - y0) / area];
  for (let row = firstRow; row <= lastRow; ++row) {
    const [dx, dy] = [firstColumn + 0.5 - x0, row + 0.5 - y0];
    let b = (dx * (y2 - y0) - dy * (x2 - x0)) / area;
    let c = (dy * (x1 - x0) - dx * (y1 - y0)) / area;
    for (let column = firstColumn; column <= lastColumn; ++column) {
      if (b >= -tolerance && c >= -tolerance && b + c <= 1 + tolerance) {
        visit(row * grid.width + column, b, c);
      }
      b += bStep;
      c += cStep;
    }
  }
}

/** Visits all dots whose middles lie in a convex walk, or no farther than `beyond` mm outside its sides. */
export function coverConvex(
  grid: Grid,
  walk: readonly Point[],
  beyond: number,
  visit: (dot: number) => void,
): void {
  const points = walk.map((point) => dotAt(grid, point));
  const reach = beyond * grid.density;
  const span = (axis: 0 | 1): number[] =>
    points.flatMap((point) => [point[axis] - 2 * reach, point[axis] + 2 * reach]);
  const [firstRow, lastRow] = range(span(1), grid.height);
  const [firstColumn, lastColumn] = range(span(0), grid.width);
  const sides = outwardSides(points);
  for (let row = firstRow; row <= lastRow; ++row) {
    for (let column = firstColumn; column <= lastColumn; ++column) {
      const isNear = sides.every(
        ([nx, ny, d]) => nx * (column + 0.5) + ny * (row + 0.5) - d <= reach + tolerance,
      );
      if (isNear) visit(row * grid.width + column);
    }
  }
}

/** Per side its normal, outwards and of length one, and how far it lies along that. */
function outwardSides(points: readonly Point[]): [nx: number, ny: number, d: number][] {
  const sides = points.map(([x, y], i) => {
    const [u, v] = points[(i + 1) % points.length]!;
    const length = Math.hypot(u - x, v - y) || 1;
    // y goes down, where a walk that is counter-clockwise on paper has its outside on this side.
    const [nx, ny] = [-(v - y) / length, (u - x) / length];
    return [nx, ny, nx * x + ny * y] as [number, number, number];
  });
  return sides;
}
