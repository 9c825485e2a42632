import { describe, expect, it } from 'vitest';
import { writeSvg } from '../../web/export/svg.js';
import type { PrintOptions } from '../../web/model/print-options.js';
import type { SheetDrawing } from '../../web/export/sheet-drawing.js';
import { cubeResult, flapResult, slitResult } from './fixtures.js';
import { printOf } from './printed.js';

type Line = [from: [number, number], to: [number, number]];

const foldsOf = ({ pieces }: SheetDrawing): Line[] =>
  pieces.flatMap(({ mountains, valleys }) => [...mountains, ...valleys]);

const lengthOf = ([[x, y], [u, v]]: Line): number => Math.hypot(u - x, v - y);

async function folds(result = cubeResult(), options: Partial<PrintOptions> = {}): Promise<Line[]> {
  const { sheets } = await printOf(result, { options });
  return sheets.flatMap(foldsOf);
}

/** The tick that begins at the first point of a fold of this direction and length. */
function tickAt([[x, y], [u, v]]: Line, length: number): Line {
  const share =
    length /
    lengthOf([
      [x, y],
      [u, v],
    ]);
  return [
    [x, y],
    [x + share * (u - x), y + share * (v - y)],
  ];
}

function expectTicks(ticks: Line[], lines: Line[], length: (line: Line) => number): void {
  expect(ticks).toHaveLength(2 * lines.length);
  lines.forEach((line, i) => {
    const expected = [tickAt(line, length(line)), tickAt([line[1], line[0]], length(line))];
    for (const [k, tick] of expected.entries()) {
      tick.flat().forEach((value, at) => {
        expect(ticks[2 * i + k]!.flat()[at]).toBeCloseTo(value, 9);
      });
    }
  });
}

describe('fold ticks', () => {
  it.each([
    ['a cube', cubeResult],
    ['a slit sheet', slitResult],
    ['a flap', flapResult],
  ])('are 3 mm at both ends of each fold of %s', async (_, result) => {
    const lines = await folds(result());
    expect(lines.length).toBeGreaterThan(0);
    expectTicks(await folds(result(), { foldTicks: true }), lines, () => 3);
  });

  it('are a third of folds that are shorter than 9 mm', async () => {
    const small = cubeResult();
    const [piece] = small.pieces;
    piece!.vertices = piece!.vertices.map((value) => value / 8);
    const lines = await folds(small);
    expect(lengthOf(lines[0]!)).toBeCloseTo(5, 9);
    expectTicks(await folds(small, { foldTicks: true }), lines, () => 5 / 3);
  });

  it('are told in the legend, and leave cuts and all else alone', async () => {
    const [plain, ticked] = [
      await printOf(cubeResult()),
      await printOf(cubeResult(), { options: { foldTicks: true } }),
    ];
    expect(writeSvg(plain, 0)).not.toContain('fold from mark to mark');
    expect(writeSvg(ticked, 0)).toContain('fold from mark to mark');
    const others = ({ sheets }: typeof plain) =>
      sheets[0]!.pieces.map(({ cuts, texts, flaps, guides }) => ({ cuts, texts, flaps, guides }));
    expect(others(ticked)).toEqual(others(plain));
  });

  it('are for scissors only: machines score whole folds', async () => {
    const machine = 'generic';
    expect(await folds(cubeResult(), { machine, foldTicks: true })).toEqual(
      await folds(cubeResult(), { machine }),
    );
  });
});
