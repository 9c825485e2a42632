import DxfParser, { type IDxf, type ILineEntity, type ILwpolylineEntity } from 'dxf-parser';
import { describe, expect, it } from 'vitest';
import { writeDxf } from '../../web/export/dxf.js';
import { writeSvg } from '../../web/export/svg.js';
import type { JobResult } from '../../web/model/job.js';
import type { PrintOptions } from '../../web/model/print-options.js';
import { boxAndLidResult, cubeResult, flapResult, slitResult } from './fixtures.js';
import { expectGolden } from './golden.js';
import { printOf } from './printed.js';
import { readSheet, type Point } from './sheet-file.js';

const text = async (result: JobResult, options: Partial<PrintOptions> = {}): Promise<string> =>
  writeDxf(await printOf(result, { options }), 0);

async function parsed(result: JobResult, options?: Partial<PrintOptions>): Promise<IDxf> {
  return new DxfParser().parseSync(await text(result, options))!;
}

function pointsOf(entity: IDxf['entities'][number]): Point[] {
  const { vertices } = entity as ILineEntity | ILwpolylineEntity;
  return vertices.map(({ x, y }): Point => [x, y]);
}

/** What is in a layer, in the order of the file. */
function walks({ entities }: IDxf, layer: string): Point[][] {
  return entities.filter((entity) => entity.layer === layer).map(pointsOf);
}

function lengthOf(walk: Point[], closed: boolean): number {
  const ends = closed ? [...walk.slice(1), walk[0]!] : walk.slice(1);
  return ends.reduce((sum, [x, y], i) => sum + Math.hypot(x - walk[i]![0], y - walk[i]![1]), 0);
}

/** The piece of a cube with a square window of 10 mm, which its outlines name last. */
function windowResult(): JobResult {
  const result = cubeResult();
  const [piece] = result.pieces;
  const first = piece!.vertices.length / 2;
  const window = [55, 55, 55, 65, 65, 65, 65, 55];
  piece!.vertices = Float64Array.from([...piece!.vertices, ...window]);
  piece!.outlines = [...piece!.outlines, Int32Array.from([0, 1, 2, 3], (i) => first + i)];
  return result;
}

describe('writeDxf', () => {
  it('is a drawing of release 2000 in mm, with all layers', async () => {
    const { header, tables } = await parsed(cubeResult());
    expect(header['$ACADVER']).toBe('AC1015');
    expect(header['$INSUNITS']).toBe(4);
    expect(header['$EXTMAX']).toMatchObject({ x: 210, y: 297 });
    const { layers } = tables.layer;
    const colours = Object.values(layers).map(({ name, colorIndex }) => [name, colorIndex]);
    expect(colours).toEqual([
      ['0', 7],
      ['REGISTRATION', 7],
      ['MOUNTAIN', 5],
      ['VALLEY', 3],
      ['TEXT', 6],
      ['CUT', 1],
    ]);
  });

  it('has true lengths', async () => {
    const drawing = await parsed(cubeResult());
    const [cut, ...others] = walks(drawing, 'CUT');
    expect(others).toEqual([]);
    // The cross has 14 sides of 40 mm around it.
    expect(Math.abs(lengthOf(cut!, true) - 14 * 40)).toBeLessThan(0.01);
    const folds = walks(drawing, 'MOUNTAIN');
    expect(folds).toHaveLength(5);
    for (const fold of folds) expect(Math.abs(lengthOf(fold, false) - 40)).toBeLessThan(0.01);
  });

  it.each([
    ['a cube', cubeResult],
    ['flaps', flapResult],
    ['a slit', slitResult],
    ['a box and its lid', boxAndLidResult],
  ])('draws %s where the SVG does', async (_, make) => {
    const drawing = await parsed(make());
    const { pieces } = readSheet(writeSvg(await printOf(make()), 0));
    const all = [...pieces.values()];
    for (const [layer, theirs] of [
      ['CUT', all.flatMap(({ cuts }) => cuts)],
      ['MOUNTAIN', all.flatMap(({ mountains }) => mountains)],
      ['VALLEY', all.flatMap(({ valleys }) => valleys)],
    ] as const) {
      const mine = walks(drawing, layer).flat();
      expect(mine).toHaveLength(theirs.flat().length);
      theirs.flat().forEach((point, i) => {
        point.forEach((length, axis) => expect(mine[i]![axis]).toBeCloseTo(length, 3));
      });
    }
  });

  it('closes cuts, draws folds as lines, and texts as outlines', async () => {
    const { entities } = await parsed(flapResult());
    const closed = new Set(['CUT', 'TEXT']);
    for (const entity of entities) {
      expect(entity.type).toBe(closed.has(entity.layer) ? 'LWPOLYLINE' : 'LINE');
      if (closed.has(entity.layer)) expect((entity as ILwpolylineEntity).shape).toBe(true);
    }
    expect(new Set(entities.map(({ layer }) => layer))).toEqual(new Set(['VALLEY', 'TEXT', 'CUT']));
  });

  it('cuts last, and windows before what is around them', async () => {
    const drawing = await parsed(windowResult());
    const layers = drawing.entities.map(({ layer }) => layer);
    expect(layers.lastIndexOf('TEXT')).toBeLessThan(layers.indexOf('CUT'));
    const [window, outline] = walks(drawing, 'CUT');
    expect(lengthOf(window!, true)).toBeCloseTo(40, 2);
    expect(lengthOf(outline!, true)).toBeCloseTo(14 * 40, 2);
  });

  it('has the marks of a Silhouette', async () => {
    const marks = walks(await parsed(cubeResult(), { machine: 'silhouette' }), 'REGISTRATION');
    expect(marks).toEqual([
      [
        [10, 287],
        [10, 282],
        [15, 282],
        [15, 287],
      ],
      [
        [180, 287],
        [200, 287],
        [200, 267],
      ],
      [
        [30, 10],
        [10, 10],
        [10, 30],
      ],
    ]);
    expect(walks(await parsed(cubeResult(), { machine: 'cricut' }), 'REGISTRATION')).toEqual([]);
  });

  it('gives every handle once, below the next free one', async () => {
    const lines = (await text(flapResult())).split('\n');
    const pairs = lines.flatMap((line, i) => (i % 2 === 0 ? [[line, lines[i + 1]!] as const] : []));
    const seed = pairs.findIndex(([, value]) => value === '$HANDSEED') + 1;
    const handles = pairs.filter(([code], i) => (code === '5' && i !== seed) || code === '105');
    const numbers = handles.map(([, value]) => Number.parseInt(value, 16));
    expect(new Set(numbers).size).toBe(numbers.length);
    expect(Number.parseInt(pairs[seed]![1], 16)).toBe(Math.max(...numbers) + 1);
  });

  it('keeps the format of the file', async () => {
    const result = slitResult();
    result.pieces[0]!.labels = [];
    expectGolden('slit.dxf', await text(result, { machine: 'silhouette' }));
    expect(await text(flapResult())).toBe(await text(flapResult()));
  });
});
