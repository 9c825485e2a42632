/** Bodies are united exactly, and each face of what comes out knows where it comes from. */
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { describe, expect, it } from 'vitest';
import { makeUniter } from '../../web/core/solid-uniter.js';
import type { Solid, UnitedSolids } from '../../web/model/solids.js';
import { cube } from './fixtures.js';

type Point = [number, number, number];

const uniter = makeUniter(
  await readFile(createRequire(import.meta.url).resolve('manifold-3d/manifold.wasm')),
);

function box(least: Point, most: Point, isInsideOut = false): Solid {
  const positions = cube.vertices.flatMap((at) =>
    at.map((coordinate, k) => (coordinate === 0 ? least : most)[k]!),
  );
  const faces = cube.faces.flatMap((face) => (isInsideOut ? [...face].reverse() : face));
  return { positions: Float64Array.from(positions), faces: Int32Array.from(faces) };
}

function together(...solids: Solid[]): Solid {
  const positions = solids.flatMap((solid) => [...solid.positions]);
  let first = 0;
  const faces = solids.flatMap((solid) => {
    const moved = [...solid.faces].map((vertex) => vertex + first);
    first += solid.positions.length / 3;
    return moved;
  });
  return { positions: Float64Array.from(positions), faces: Int32Array.from(faces) };
}

function pointsOf({ positions, faces }: Solid, face: number): [Point, Point, Point] {
  const point = (k: number): Point => {
    const vertex = faces[3 * face + k]!;
    return [...positions.subarray(3 * vertex, 3 * vertex + 3)] as Point;
  };
  return [point(0), point(1), point(2)];
}

const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const area = ([a, b, c]: [Point, Point, Point]): Point => cross(minus(b, a), minus(c, a));

function volume(solid: Solid): number {
  let sum = 0;
  for (let face = 0; face < solid.faces.length / 3; ++face) {
    const [a, b, c] = pointsOf(solid, face);
    sum += dot(a, cross(b, c)) / 6;
  }
  return sum;
}

/** Each edge once in either direction, and each face on the one that it comes from. */
function expectSurface(united: UnitedSolids, solids: Solid[]): void {
  const half = new Set<string>();
  for (let i = 0; i < united.faces.length; ++i) {
    const next = i % 3 === 2 ? i - 2 : i + 1;
    half.add(`${united.faces[i]} ${united.faces[next]}`);
  }
  expect(half.size).toBe(united.faces.length);
  for (const edge of half) expect(half.has(edge.split(' ').reverse().join(' '))).toBe(true);

  const all = together(...solids);
  expect(united.sources.length).toBe(united.faces.length / 3);
  for (let face = 0; face < united.sources.length; ++face) {
    const source = pointsOf(all, united.sources[face]!);
    const normal = area(source);
    expect(dot(area(pointsOf(united, face)), normal)).toBeGreaterThan(0);
    for (const point of pointsOf(united, face)) {
      expect(Math.abs(dot(minus(point, source[0]), normal))).toBeLessThan(1e-14);
    }
  }
}

describe('the uniter', () => {
  // Numbers that single floats do not have.
  const large = box([0.1, 0.1, 0.1], [0.7, 0.7, 0.7]);
  const small = box([0.4, 0.3, 0.2], [0.9, 0.6, 0.5]);

  it('makes one surface of two boxes, to the last bit of their places', async () => {
    const united = (await uniter)([large, small])!;
    expectSurface(united, [large, small]);
    expect(volume(united)).toBeCloseTo(0.6 ** 3 + 0.2 * 0.3 * 0.3, 14);
    const places = new Set(united.positions);
    for (const place of [0.1, 0.7, 0.9, 0.3, 0.6, 0.2, 0.5]) expect(places).toContain(place);
  });

  it('keeps the hollow of a body, and what stands in it', async () => {
    const hollow = together(large, box([0.2, 0.2, 0.2], [0.6, 0.6, 0.6], true));
    const united = (await uniter)([hollow, small])!;
    expectSurface(united, [hollow, small]);
    const wall = 0.6 ** 3 - 0.4 ** 3;
    expect(volume(united)).toBeCloseTo(wall + 0.2 * 0.3 * 0.3 + 0.2 * 0.3 * 0.3, 14);
  });

  it('gives the same bits again, and bodies that are apart as they are', async () => {
    const far = box([2, 2, 2], [3, 3, 3]);
    const unite = await uniter;
    const united = unite([large, far])!;
    expectSurface(united, [large, far]);
    expect(united.faces.length).toBe(large.faces.length + far.faces.length);
    expect(unite([large, far])).toEqual(united);
  });

  it('says that it cannot unite what has no inside', async () => {
    const open = { ...large, faces: large.faces.subarray(6) };
    expect((await uniter)([open, small])).toBeNull();
  });
});
