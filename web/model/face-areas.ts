import { cross, length, minus, vectorAt } from './vector.js';

/** Areas of the faces of a model, in its units. */
export function areasOf(model: { vertices: ArrayLike<number>; faces: Int32Array }): Float64Array {
  const { faces, vertices } = model;
  return Float64Array.from({ length: faces.length / 3 }, (_, face) => {
    const [a, b, c] = [0, 1, 2].map((corner) => vectorAt(vertices, faces[3 * face + corner]!));
    return length(cross(minus(b!, a!), minus(c!, a!))) / 2;
  });
}
