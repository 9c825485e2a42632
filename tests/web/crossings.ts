/** Whether surfaces pass through each other, pair by pair and in the plainest way. */
import { cross, dot, minus, plus, times, type Vector } from '../../web/model/vector.js';

export type Triangle = readonly [Vector, Vector, Vector];

/** Glued edges touch: triangles are drawn in by this share before they are compared. */
const inset = 0.03;

function drawnIn(corners: Triangle): Triangle {
  const middle = times(plus(plus(corners[0], corners[1]), corners[2]), 1 / 3);
  const draw = (corner: Vector): Vector => plus(middle, times(minus(corner, middle), 1 - inset));
  return [draw(corners[0]), draw(corners[1]), draw(corners[2])];
}

function meets(from: Vector, to: Vector, [a, b, c]: Triangle): boolean {
  const [along, u, v] = [minus(to, from), minus(b, a), minus(c, a)];
  const across = cross(along, v);
  const volume = dot(u, across);
  if (volume === 0) return false;
  const s = dot(minus(from, a), across) / volume;
  const other = cross(minus(from, a), u);
  const t = dot(along, other) / volume;
  const share = dot(v, other) / volume;
  return s >= 0 && t >= 0 && s + t <= 1 && share >= 0 && share <= 1;
}

function boxesMeet(a: Triangle, b: Triangle): boolean {
  return [0, 1, 2].every((axis) => {
    const [p, q] = [a, b].map((triangle) => triangle.map((corner) => corner[axis]!));
    return Math.max(...p!) >= Math.min(...q!) && Math.max(...q!) >= Math.min(...p!);
  });
}

/** Counts the pairs of triangles, one of each surface, that cut through each other. */
export function countCrossings(a: readonly Triangle[], b: readonly Triangle[]): number {
  const [first, second] = [a.map(drawnIn), b.map(drawnIn)];
  const sides = [0, 1, 2];
  let count = 0;
  for (const p of first) {
    for (const q of second) {
      if (!boxesMeet(p, q)) continue;
      const cuts = sides.some(
        (i) => meets(p[i]!, p[(i + 1) % 3]!, q) || meets(q[i]!, q[(i + 1) % 3]!, p),
      );
      if (cuts) ++count;
    }
  }
  return count;
}
