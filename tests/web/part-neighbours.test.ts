import { describe, expect, it } from 'vitest';
import { hangTogether, partNeighbours } from '../../web/model/part-neighbours.js';
import { cube } from './fixtures.js';

/** The cube with a part for each of its sides, which are two faces each. */
const sides = partNeighbours({
  model: {
    vertices: Float64Array.from(cube.vertices.flat()),
    faces: Int32Array.from(cube.faces.flat()),
    components: 1,
  },
  labels: Int32Array.from(cube.faces, (_, face) => Math.floor(face / 2)),
  parts: 6,
});

describe('partNeighbours', () => {
  it('finds the four sides around each side of a cube', () => {
    expect(sides.map(({ size }) => size)).toEqual([4, 4, 4, 4, 4, 4]);
    sides.forEach((around, side) => {
      expect(around.has(side)).toBe(false);
      for (const other of around) expect(sides[other]!.has(side)).toBe(true);
    });
  });
});

describe('hangTogether', () => {
  it('is not so for two sides that face each other, unless one between is chosen, too', () => {
    const across = [...sides.keys()].find((side) => side !== 0 && !sides[0]!.has(side))!;
    const between = [...sides[0]!][0]!;
    expect(hangTogether(sides, [0, between])).toBe(true);
    expect(hangTogether(sides, [0, across])).toBe(false);
    expect(hangTogether(sides, [0, across, between])).toBe(true);
  });

  it('is so for one part, and for none', () => {
    expect(hangTogether(sides, [3])).toBe(true);
    expect(hangTogether(sides, [])).toBe(true);
  });
});
