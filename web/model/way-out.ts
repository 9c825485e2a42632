import { facing, type Triangles } from './facing.js';
import { cross, direction, dot, vectorAt, type Vector } from './vector.js';

// More find little that these do not: what has no way out among them is hooked.
const directions = 24;

/** Directions all around, evenly: a spiral from pole to pole by the golden angle. */
const around: readonly Vector[] = Array.from({ length: directions }, (_, i) => {
  const z = (2 * i + 1) / directions - 1;
  const angle = i * Math.PI * (3 - Math.sqrt(5));
  const radius = Math.sqrt(1 - z * z);
  return [radius * Math.cos(angle), radius * Math.sin(angle), z];
});

/** Coordinates in which z runs along a direction. */
function seenAlong(towards: Vector, triangles: Triangles): Triangles {
  const x = direction(cross(Math.abs(towards[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], towards));
  const y = cross(towards, x);
  const seen = new Float64Array(triangles.length);
  for (let i = 0; i < triangles.length / 3; ++i) {
    const point = vectorAt(triangles, i);
    seen.set([dot(point, x), dot(point, y), dot(point, towards)], 3 * i);
  }
  return seen;
}

/** How far above a point a triangle is, along z; NaN where it is neither above nor below. */
function heightAbove(t: Triangles, at: number, x: number, y: number, z: number): number {
  const [ax, ay] = [t[at]! - x, t[at + 1]! - y];
  const [bx, by] = [t[at + 3]! - x, t[at + 4]! - y];
  const [cx, cy] = [t[at + 6]! - x, t[at + 7]! - y];
  const [u, v, w] = [bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx];
  if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) return NaN;
  return (u * t[at + 2]! + v * t[at + 5]! + w * t[at + 8]!) / (u + v + w) - z;
}

/** Counts the triangles of which the middle has one of the others above it (`side` 1) or below (-1). */
function countCovered(triangles: Triangles, others: Triangles, side: number): number {
  let covered = 0;
  for (let i = 0; i < triangles.length; i += 9) {
    const middle = (k: number): number =>
      (triangles[i + k]! + triangles[i + k + 3]! + triangles[i + k + 6]!) / 3;
    const [x, y, z] = [middle(0), middle(1), middle(2)];
    for (let at = 0; at < others.length; at += 9) {
      if (!(side * heightAbove(others, at, x, y, z) > 0)) continue;
      ++covered;
      break;
    }
  }
  return covered;
}

/**
 * The direction in which a piece is drawn straight out of others with least in its way; the other
 * way round it comes in. Looks along a few directions, the one that the piece faces first, and at
 * the middles of faces only: a good way is found where there is one, but none is proved free.
 */
export function wayOut(piece: Triangles, others: Triangles): Vector {
  const front = facing(piece);
  const candidates = [front, ...[...around].sort((a, b) => dot(b, front) - dot(a, front))];
  let [best, least] = [front, Infinity];
  for (const candidate of candidates) {
    const [moving, still] = [seenAlong(candidate, piece), seenAlong(candidate, others)];
    const blocked = countCovered(moving, still, 1) + countCovered(still, moving, -1);
    if (blocked < least) [best, least] = [candidate, blocked];
    if (least === 0) break;
  }
  return best;
}
