/** Convex polygons, counter-clockwise, and what remains of them when others are cut away. */
import type { Point } from './point.js';
import { areaOf } from './polygon.js';

/** The side of a line on which x * a + y * b + c is not negative. */
export type HalfPlane = readonly [a: number, b: number, c: number];

/** The half-plane at the left of a way from one point to another; its length is that of the way. */
export function leftOf([x, y]: Point, [u, v]: Point): HalfPlane {
  const [dx, dy] = [u - x, v - y];
  return [-dy, dx, dy * x - dx * y];
}

/** How far a point lies within a half-plane, times the length of its first two numbers. */
export function depthIn([a, b, c]: HalfPlane, [x, y]: Point): number {
  return a * x + b * y + c;
}

/** The parts of a convex polygon within and beyond the edge of a half-plane; empty where there is none. */
export function halves(
  polygon: readonly Point[],
  plane: HalfPlane,
): { within: Point[]; beyond: Point[] } {
  const depths = polygon.map((point) => depthIn(plane, point));
  const within: Point[] = [];
  const beyond: Point[] = [];
  polygon.forEach((point, i) => {
    const next = (i + 1) % polygon.length;
    const [here, there] = [depths[i]!, depths[next]!];
    if (here >= 0) within.push(point);
    if (here <= 0) beyond.push(point);
    if (here * there >= 0) return;
    // From the same end on both sides of the edge, so that both get the same digits.
    const share = here / (here - there);
    const [[x, y], [u, v]] = [point, polygon[next]!];
    const crossing: Point = [x + share * (u - x), y + share * (v - y)];
    within.push(crossing);
    beyond.push(crossing);
  });
  return { within, beyond };
}

/** The half-planes that a convex polygon is the intersection of. */
export function sidesOf(polygon: readonly Point[]): HalfPlane[] {
  return polygon.map((point, i) => leftOf(point, polygon[(i + 1) % polygon.length]!));
}

/** What of a convex polygon lies within all half-planes; empty if nothing does. */
export function clipped(polygon: readonly Point[], planes: readonly HalfPlane[]): Point[] {
  let rest = [...polygon];
  for (const plane of planes) {
    if (rest.length < 3) return [];
    rest = halves(rest, plane).within;
  }
  return rest.length < 3 ? [] : rest;
}

/**
 * What of a convex polygon lies outside the intersection of half-planes, as convex polygons that share
 * no area.
 *
 * @param least pieces of less area are dropped
 */
export function remainder(
  polygon: readonly Point[],
  planes: readonly HalfPlane[],
  least: number,
): Point[][] {
  const outside: Point[][] = [];
  let rest = [...polygon];
  for (const plane of planes) {
    const { within, beyond } = halves(rest, plane);
    if (beyond.length >= 3 && areaOf(beyond) > least) outside.push(beyond);
    rest = within;
    if (rest.length < 3 || areaOf(rest) <= least) break;
  }
  return outside;
}
