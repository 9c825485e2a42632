/**
 * Naive surface nets over a field that is symmetric in x: one vertex per grid cell that the
 * surface crosses, one quad per grid edge that it crosses. Only the half with x >= 0 is built.
 */
import { add, subtract } from './vector.mjs';

const AXES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
/** Corners of a cell: bit 0 is x, bit 1 is y, bit 2 is z. */
const CORNERS = Array.from({ length: 8 }, (_, bits) => [bits & 1, (bits >> 1) & 1, bits >> 2]);
const EDGES = CORNERS.flatMap((_, from) =>
  [1, 2, 4].filter((bit) => !(from & bit)).map((bit) => [from, from | bit]),
);

/** Field values at the grid's corners; the first layer of cells straddles x = 0. */
function sampleGrid(field, min, max, step) {
  const counts = [0, 1, 2].map(
    (k) => Math.ceil((max[k] - (k === 0 ? 0 : min[k])) / step + (k === 0 ? 0.5 : 0)) + 1,
  );
  const origin = [-step / 2, min[1], min[2]];
  const [nx, ny, nz] = counts;
  const values = new Float64Array(nx * ny * nz);
  const index = (i, j, k) => i + nx * (j + ny * k);
  for (let k = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      for (let i = 0; i < nx; i++) {
        const p = [origin[0] + i * step, origin[1] + j * step, origin[2] + k * step];
        values[index(i, j, k)] = field(p);
      }
    }
  }
  return { counts, origin, step, values, index };
}

/** Mean of the points where the surface crosses the edges of one cell; null when it does not. */
function cellPoint(grid, i, j, k) {
  const values = CORNERS.map(([x, y, z]) => grid.values[grid.index(i + x, j + y, k + z)]);
  const sum = [0, 0, 0];
  let crossings = 0;
  for (const [a, b] of EDGES) {
    if (values[a] < 0 === values[b] < 0) continue;
    const t = values[a] / (values[a] - values[b]);
    for (let axis = 0; axis < 3; axis++) {
      sum[axis] += CORNERS[a][axis] + t * (CORNERS[b][axis] - CORNERS[a][axis]);
    }
    crossings++;
  }
  if (crossings === 0) return null;
  return [i, j, k].map((n, axis) => grid.origin[axis] + (n + sum[axis] / crossings) * grid.step);
}

/** Indices of all cells, from `first` on in every direction. */
function* cells([nx, ny, nz], first) {
  for (let k = first; k < nz - 1; k++) {
    for (let j = first; j < ny - 1; j++) {
      for (let i = first; i < nx - 1; i++) yield [i, j, k];
    }
  }
}

/** Vertices of all crossed cells, and the map from cell to vertex. */
function placeVertices(grid) {
  const vertices = [];
  const vertexOf = new Map();
  for (const [i, j, k] of cells(grid.counts, 0)) {
    const point = cellPoint(grid, i, j, k);
    if (point === null) continue;
    if (i === 0) point[0] = 0; // the straddling layer is the seam of the two halves
    vertexOf.set(grid.index(i, j, k), vertices.length);
    vertices.push(point);
  }
  return { vertices, vertexOf };
}

/**
 * Polygonises the half x >= 0 of the solid inside the box [min, max].
 *
 * @param field function of a point, negative inside, symmetric in x
 * @param step width of a grid cell
 * @returns {{vertices: number[][], faces: number[][]}} triangles, outward, open only along x = 0
 */
export function surfaceNets(field, min, max, step) {
  const grid = sampleGrid(field, min, max, step);
  const { vertices, vertexOf } = placeVertices(grid);
  const inside = ([i, j, k]) => grid.values[grid.index(i, j, k)] < 0;
  const faces = [];
  for (const corner of cells(grid.counts, 1)) {
    AXES.forEach((axis, a) => {
      if (inside(corner) === inside(add(corner, axis))) return;
      // The four cells around this grid edge, counter-clockwise as seen from the far end.
      const [u, v] = [AXES[(a + 1) % 3], AXES[(a + 2) % 3]];
      const lowest = subtract(subtract(corner, u), v);
      const quad = [lowest, add(lowest, u), corner, add(lowest, v)].map((cell) =>
        vertexOf.get(grid.index(...cell)),
      );
      if (!inside(corner)) quad.reverse();
      faces.push([quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]);
    });
  }
  return { vertices, faces };
}
