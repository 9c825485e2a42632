/** Where surfaces look to. */
import type { EdgeName, Model } from './job.js';
import { cross, direction, minus, plus, vectorAt, type Vector } from './vector.js';

/** Triangles in space, 9 numbers each. */
export type Triangles = Float64Array;

/** The mean normal, weighted by area: where triangles face as a whole. */
export function facing(triangles: Triangles): Vector {
  let sum: Vector = [0, 0, 0];
  for (let at = 0; at < triangles.length / 3; at += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => vectorAt(triangles, at + corner));
    sum = plus(sum, cross(minus(b!, a!), minus(c!, a!)));
  }
  return direction(sum);
}

/** The triangles that some faces of a model are. */
export function trianglesOf({ vertices, faces }: Model, chosen: readonly number[]): Triangles {
  return Float64Array.from(
    chosen.flatMap((face) =>
      [0, 1, 2].flatMap((corner) => vectorAt(vertices, faces[3 * face + corner]!)),
    ),
  );
}

/** The faces beside an edge: one, or two. Looks at all faces. */
export function facesBeside({ faces }: Model, [v, w]: EdgeName): number[] {
  const found: number[] = [];
  for (let face = 0; face < faces.length / 3; ++face) {
    const corners = faces.subarray(3 * face, 3 * face + 3);
    if (corners.includes(v) && corners.includes(w)) found.push(face);
  }
  return found;
}
