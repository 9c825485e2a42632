import { describe, expect, it } from 'vitest';
import { NearestFace, nearestShares } from '../../web/model/nearest-face.js';
import type { Vector } from '../../web/model/vector.js';

/** Numbers from 0 to 1 that are the same every time. */
function numbersFrom(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 2 ** 32;
  };
}

const next = numbersFrom(7);
const somewhere = (): Vector => [next(), next(), next()];

/** The square of the way from a point to shares of a triangle. */
function squareTo(point: Vector, corners: ArrayLike<number>, b: number, c: number): number {
  return [0, 1, 2].reduce((sum, axis) => {
    const at = (1 - b - c) * corners[axis]! + b * corners[3 + axis]! + c * corners[6 + axis]!;
    return sum + (point[axis]! - at) ** 2;
  }, 0);
}

describe('nearestShares', () => {
  it('is nearer than any other point of the triangle', () => {
    const shares = new Float64Array(2);
    for (let i = 0; i < 200; ++i) {
      const corners = Float64Array.from([somewhere(), somewhere(), somewhere()].flat());
      const point = somewhere().map((value) => 3 * value - 1) as unknown as Vector;
      nearestShares(point, corners, 0, shares);
      const [b, c] = [shares[0]!, shares[1]!];
      expect(Math.min(b, c, 1 - b - c)).toBeGreaterThan(-1e-12);
      const least = squareTo(point, corners, b, c);
      for (let j = 0; j < 50; ++j) {
        const [u, v] = [next(), next()];
        const [p, q] = u + v > 1 ? [1 - u, 1 - v] : [u, v];
        expect(squareTo(point, corners, p, q)).toBeGreaterThan(least - 1e-12);
      }
    }
  });
});

describe('NearestFace', () => {
  it('finds what a look at every face finds, with a hint or without', () => {
    const count = 300;
    const vertices = Float64Array.from({ length: 9 * count }, (_, i) => {
      const face = Math.floor(i / 9);
      return numbersFrom(face * 3 + (i % 3))() + next() * 0.1;
    });
    const faces = Int32Array.from({ length: 3 * count }, (_, i) => i);
    const tree = new NearestFace({ vertices, faces });
    const shares = new Float64Array(2);
    for (let i = 0; i < 100; ++i) {
      const point = somewhere();
      const place = tree.find(point, [0, 0, 1], i % 2 === 0 ? -1 : i)!;
      const found = squareTo(point, vertices.subarray(9 * place.face), place.b, place.c);
      let least = Infinity;
      for (let face = 0; face < count; ++face) {
        const [px, py, , qx, qy, , rx, ry] = vertices.subarray(9 * face, 9 * face + 9);
        const looksUp = (qx! - px!) * (ry! - py!) - (rx! - px!) * (qy! - py!) > 0;
        if (!looksUp) continue;
        nearestShares(point, vertices, 9 * face, shares);
        const square = squareTo(point, vertices.subarray(9 * face), shares[0]!, shares[1]!);
        least = Math.min(least, square);
      }
      expect(found).toBeCloseTo(least, 12);
    }
  });

  it('finds nothing where all faces look the other way', () => {
    const surface = {
      vertices: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
      faces: Int32Array.of(0, 1, 2),
    };
    expect(new NearestFace(surface).find([0, 0, 1], [0, 0, -1], -1)).toBeNull();
    expect(new NearestFace(surface).find([0.25, 0.25, 1], [0, 0, 1], -1)).toEqual({
      face: 0,
      b: 0.25,
      c: 0.25,
    });
  });
});
