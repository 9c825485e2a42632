/** Separate bodies of a mesh. */
import { describe, expect, it } from 'vitest';
import { extentsOf } from '../../web/model/bounds.js';
import { componentsOf, isTiny } from '../../web/model/components.js';
import { cube } from './fixtures.js';

/** Two cubes, the second one a hundredth as large and to the right. */
const vertices = Float32Array.from([
  ...cube.vertices.flat(),
  ...cube.vertices.flatMap(([x, y, z]) => [x! / 100 + 100, y! / 100, z! / 100]),
]);
const first = cube.faces.flat();
const second = first.map((vertex) => vertex + cube.vertices.length);

const noPause = async (): Promise<void> => {};

describe('componentsOf', () => {
  it('tells bodies apart whatever the order of their faces', async () => {
    const mixed = first.flatMap((_, i) =>
      i % 3 === 0 ? [...first.slice(i, i + 3), ...second.slice(i, i + 3)] : [],
    );
    const { components, ofFaces } = await componentsOf(vertices, Int32Array.from(mixed), noPause);
    expect(components.map(({ faces }) => faces)).toEqual([12, 12]);
    expect(components[0]!.longestSide).toBe(40);
    expect(components[1]!.longestSide).toBeCloseTo(0.4, 4);
    expect([...ofFaces]).toEqual(Array.from({ length: 24 }, (_, face) => face % 2));
    const longest = Math.max(...extentsOf(vertices));
    expect(components.map((component) => isTiny(component, longest))).toEqual([false, true]);
  });

  it('ends when its pause does', async () => {
    const end = (): Promise<void> => Promise.reject(new Error('enough'));
    await expect(componentsOf(vertices, Int32Array.from(first), end)).rejects.toThrow('enough');
  });

  it('finds none in nothing', async () => {
    const { components } = await componentsOf(new Float32Array(), new Int32Array(), noPause);
    expect(components).toEqual([]);
  });
});
