import { describe, expect, it } from 'vitest';
import { placeLabel } from '../../web/export/label-place.js';
import { pieceLetter } from '../../web/model/piece-letter.js';
import { cubeResult } from './fixtures.js';

describe('pieceLetter', () => {
  it('counts like the columns of a table', () => {
    const letters = [0, 1, 25, 26, 27, 51, 52, 701, 702].map(pieceLetter);
    expect(letters).toEqual(['A', 'B', 'Z', 'AA', 'AB', 'AZ', 'BA', 'ZZ', 'AAA']);
  });
});

describe('placeLabel', () => {
  const piece = cubeResult().pieces[0]!;

  it('keeps the text inside one face', () => {
    const label = placeLabel(piece, 'AB')!;
    // A generous box around two capitals, against the grid of squares and their diagonals.
    const corners = [-1, 1].flatMap((i) =>
      [-1, 1].map((j) => [label.x + i * 0.8 * label.size, label.y + j * 0.36 * label.size]),
    );
    const cells = corners.map(([x, y]) => [Math.floor(x! / 40), Math.floor(y! / 40)].join());
    expect(new Set(cells).size).toBe(1);
    const sides = corners.map(([x, y]) => Math.sign((x! % 40) + (y! % 40) - 40));
    const others = corners.map(([x, y]) => Math.sign((x! % 40) - (y! % 40)));
    expect(Math.min(new Set(sides).size, new Set(others).size)).toBe(1);
  });

  it('shrinks the text before it gives up', () => {
    const scaled = (factor: number) => ({
      ...piece,
      vertices: piece.vertices.map((value) => value * factor),
    });
    expect(placeLabel(scaled(1), 'A')!.size).toBe(6);
    expect(placeLabel(scaled(0.25), 'A')!.size).toBeLessThan(6);
    expect(placeLabel(scaled(0.05), 'A')).toBeNull();
  });
});
