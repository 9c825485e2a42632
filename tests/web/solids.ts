/** Small closed solids for tests of readers, counter-clockwise from outside. */
import type { Triangles } from './read-model.js';

/** A box from the origin: volume is the product of its sides. */
export function box(x: number, y: number, z: number): Triangles {
  const positions = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
    i & 1 ? x : 0,
    i & 2 ? y : 0,
    i & 4 ? z : 0,
  ]);
  const quads = ['0462', '1375', '0154', '2673', '0231', '4576'];
  const corners = quads.flatMap((quad) => {
    const [a, b, c, d] = [...quad].map(Number) as [number, number, number, number];
    return [a, b, c, a, c, d];
  });
  return { positions, corners };
}

/** An OBJ file of it. */
export function objOf({ positions, corners }: Triangles): string {
  const rows = (values: number[], word: string, add: number): string[] =>
    Array.from({ length: values.length / 3 }, (_, i) => {
      const row = values.slice(3 * i, 3 * i + 3).map((value) => value + add);
      return `${word} ${row.join(' ')}`;
    });
  return [...rows(positions, 'v', 0), ...rows(corners, 'f', 1)].join('\n');
}
