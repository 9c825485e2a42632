/**
 * Quadrics: the sum of squared distances to planes, as the upper triangle of a symmetric matrix,
 * `xx xy xz xw yy yz yw zz zw ww`.
 */
import { dot, length, scale, triangleNormal } from './vector.mjs';

/** Pull to the middle of the edge, which settles positions on flat ground. */
const MIDPOINT_PULL = 1e-3;

/** Quadric of a triangle's plane, weighted by its area. */
export function planeQuadric(a, b, c) {
  const n = triangleNormal(a, b, c);
  const area = length(n);
  if (area === 0) return new Array(10).fill(0);
  const [x, y, z] = scale(n, 1 / area);
  const w = -dot([x, y, z], a);
  return [x * x, x * y, x * z, x * w, y * y, y * z, y * w, z * z, z * w, w * w].map(
    (value) => value * area,
  );
}

export const addQuadrics = (p, q) => p.map((value, i) => value + q[i]);

/** The quadric together with its mirror image at x = 0. */
export function symmetrised(q) {
  return q.map((value, i) => (i === 1 || i === 2 || i === 3 ? 0 : 2 * value));
}

/** Sum of weighted squared distances from a point to the quadric's planes. */
export function quadricError(q, [x, y, z]) {
  return (
    q[0] * x * x +
    2 * x * (q[1] * y + q[2] * z + q[3]) +
    q[4] * y * y +
    2 * y * (q[5] * z + q[6]) +
    q[7] * z * z +
    2 * q[8] * z +
    q[9]
  );
}

/** Solves the symmetric 3 by 3 system of a quadric that is pulled towards `middle`. */
export function bestPoint(q, middle) {
  const pull = MIDPOINT_PULL * (q[0] + q[4] + q[7]) + 1e-12;
  const a = [
    [q[0] + pull, q[1], q[2]],
    [q[1], q[4] + pull, q[5]],
    [q[2], q[5], q[7] + pull],
  ];
  const b = [-q[3] + pull * middle[0], -q[6] + pull * middle[1], -q[8] + pull * middle[2]];
  const det = (m) =>
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  const whole = det(a);
  return [0, 1, 2].map(
    (k) => det(a.map((row, r) => row.map((v, c) => (c === k ? b[r] : v)))) / whole,
  );
}
