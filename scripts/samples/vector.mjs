/** Small vectors of three numbers, as plain arrays. */

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a) => Math.sqrt(dot(a, a));
export const mix = (a, b, t) => add(scale(a, 1 - t), scale(b, t));

export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** The vector at length 1; the zero vector stays zero. */
export function normalize(a) {
  const size = length(a);
  return size > 0 ? scale(a, 1 / size) : [0, 0, 0];
}

/** Twice the area of a triangle, as a vector along its outward normal. */
export function triangleNormal(a, b, c) {
  return cross(subtract(b, a), subtract(c, a));
}

/** Turns a vector by Euler angles in degrees: first about x, then y, then z. */
export function rotate(v, [degreesX, degreesY, degreesZ]) {
  let [x, y, z] = v;
  const turn = (p, q, degrees) => {
    const angle = (degrees * Math.PI) / 180;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return [p * c - q * s, p * s + q * c];
  };
  [y, z] = turn(y, z, degreesX);
  [z, x] = turn(z, x, degreesY);
  [x, y] = turn(x, y, degreesZ);
  return [x, y, z];
}
