/**
 * Implicit solids: functions from a point to a signed value, negative inside. They need not be
 * exact distances; the polygoniser only wants a smooth field with its zero on the surface.
 */
import { add, dot, length, rotate, subtract } from './vector.mjs';

const clamp01 = (t) => Math.min(1, Math.max(0, t));

/** Undoes `rotate` with the same angles. */
function unrotate(v, [x, y, z]) {
  return rotate(rotate(rotate(v, [0, 0, -z]), [0, -y, 0]), [-x, 0, 0]);
}

/** Ball, stretched along its own axes and turned by Euler angles in degrees. */
export function ellipsoid(centre, radii, turn = [0, 0, 0]) {
  return (p) => {
    const q = unrotate(subtract(p, centre), turn);
    const k0 = length([q[0] / radii[0], q[1] / radii[1], q[2] / radii[2]]);
    const k1 = length([q[0] / radii[0] ** 2, q[1] / radii[1] ** 2, q[2] / radii[2] ** 2]);
    return k1 > 0 ? (k0 * (k0 - 1)) / k1 : -Math.min(...radii);
  };
}

/** Cone with round ends: radius `ra` at `a`, `rb` at `b`. */
export function roundCone(a, b, ra, rb) {
  const axis = subtract(b, a);
  return (p) => {
    const along = clamp01(dot(subtract(p, a), axis) / dot(axis, axis));
    const nearest = add(a, [axis[0] * along, axis[1] * along, axis[2] * along]);
    return length(subtract(p, nearest)) - (ra + (rb - ra) * along);
  };
}

/** A chain of round cones through points [x, y, z, radius], blended over `blend`. */
export function chain(points, blend) {
  const links = points
    .slice(1)
    .map((to, i) => roundCone(points[i].slice(0, 3), to.slice(0, 3), points[i][3], to[3]));
  return blendUnion(blend, ...links);
}

/** Union whose seams are rounded over a distance `blend`. */
export function blendUnion(blend, ...solids) {
  return (p) =>
    solids
      .map((solid) => solid(p))
      .reduce((a, b) => {
        const h = Math.max(blend - Math.abs(a - b), 0) / blend;
        return Math.min(a, b) - (h * h * blend) / 4;
      });
}

/** What is left of a solid where a cutter is taken away, with a seam rounded over `blend`. */
export function carve(blend, solid, cutter) {
  return (p) => {
    const [a, b] = [solid(p), -cutter(p)];
    const h = Math.max(blend - Math.abs(a - b), 0) / blend;
    return Math.max(a, b) + (h * h * blend) / 4;
  };
}

/** Half space: inside is where `dot(normal, p) < offset`; the normal has length 1. */
export function halfSpace(normal, offset) {
  return (p) => dot(normal, p) - offset;
}

/** The solid and its mirror image at x = 0: whatever lies at positive x counts on both sides. */
export function mirrored(solid) {
  return (p) => solid([Math.abs(p[0]), p[1], p[2]]);
}
