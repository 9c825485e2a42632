import { XMLParser } from 'fast-xml-parser';
import { describe, expect, it } from 'vitest';
import { writeSvg } from '../../web/export/svg.js';
import type { JobResult } from '../../web/model/job.js';
import { boxAndLidResult, cubeResult, flapResult, slitResult } from './fixtures.js';
import { expectGolden } from './golden.js';
import { printOf } from './printed.js';
import type { PrintOptions } from '../../web/model/print-options.js';

interface Path {
  d: string;
  stroke: string;
  'stroke-dasharray'?: string;
  'data-piece': string;
}

interface Group {
  id: string;
  'inkscape:groupmode': string;
  'inkscape:label': string;
  path?: Path[];
  text?: { '#text': string; x: string; y: string; 'font-size': string; transform?: string }[];
}

interface Drawing {
  width: string;
  height: string;
  viewBox: string;
  g: Group[];
}

function parse(text: string): Drawing {
  const parser = new XMLParser({
    ignoreAttributes: false,
    attributeNamePrefix: '',
    isArray: (name) => ['g', 'path', 'text'].includes(name),
  });
  return (parser.parse(text) as { svg: Drawing }).svg;
}

function findGroup(drawing: Drawing, id: string): Group | undefined {
  return drawing.g.find((group) => group.id === id);
}

function groupOf(drawing: Drawing, id: string): Group {
  return findGroup(drawing, id)!;
}

/** The walks of a path made of absolute M, L and Z only. */
function walksOf(path: Path): number[][][] {
  return path.d
    .split('M')
    .slice(1)
    .map((walk) =>
      walk
        .replace('Z', '')
        .split('L')
        .map((point) => point.split(' ').map(Number)),
    );
}

function walks(drawing: Drawing, id: string): number[][][] {
  return (findGroup(drawing, id)?.path ?? []).flatMap(walksOf);
}

function areaOf(walk: number[][]): number {
  return (
    walk.reduce((sum, [x, y], i) => {
      const [u, v] = walk[(i + 1) % walk.length]!;
      return sum + x! * v! - u! * y!;
    }, 0) / 2
  );
}

async function written(
  result: JobResult,
  options: Partial<PrintOptions> = {},
  sheet = 0,
): Promise<string> {
  return writeSvg(await printOf(result, { options }), sheet);
}

async function parsed(result: JobResult, options?: Partial<PrintOptions>): Promise<Drawing> {
  return parse(await written(result, options));
}

async function allSheets(result: JobResult): Promise<Drawing[]> {
  const print = await printOf(result);
  return print.sheets.map((_, i) => parse(writeSvg(print, i)));
}

describe('writeSvg', () => {
  it('has true size, its groups in order, and no transforms', async () => {
    const text = await written(cubeResult());
    const drawing = parse(text);
    expect([drawing.width, drawing.height]).toEqual(['210mm', '297mm']);
    expect(drawing.viewBox).toBe('0 0 210 297');
    expect(drawing.g.map(({ id }) => id)).toEqual(['guide', 'fold-mountain', 'id', 'cut']);
    // The ruler at the left edge is read from the side.
    expect(text.replace(/<text.*<\/text>/g, '')).not.toMatch(/transform|style|class/);
  });

  it('writes groups as layers of Inkscape, and none that is empty', async () => {
    const results = [cubeResult(), slitResult(), flapResult()];
    for (const style of ['foldwright', 'blender'] as const) {
      for (const result of results) {
        const text = await written(result, { style });
        expect(text).toContain('xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"');
        const { g } = parse(text);
        for (const {
          'inkscape:groupmode': mode,
          'inkscape:label': label,
          path,
          text: lines,
        } of g) {
          expect(mode).toBe('layer');
          expect(label).toMatch(/^[A-Z]/);
          expect((path?.length ?? 0) + (lines?.length ?? 0)).toBeGreaterThan(0);
        }
        expect(new Set(g.map((group) => group['inkscape:label'])).size).toBe(g.length);
      }
    }
    const shaded = parse(await written(flapResult(), { style: 'blender' }));
    expect(shaded.g.map(({ id }) => id)).toEqual(['guide', 'flap', 'fold-valley', 'id', 'cut']);
  });

  it('cuts out exactly the area of the model', async () => {
    const drawings = await allSheets(boxAndLidResult());
    // Flipped once, a counter-clockwise walk turns clockwise, and its area negative.
    const area = drawings.flatMap((drawing) => walks(drawing, 'cut')).map(areaOf);
    expect(area).toHaveLength(2);
    expect(-area.reduce((sum, value) => sum + value)).toBeCloseTo(6 * 40 * 40, 1);
  });

  it('draws the folds of the cube but not the diagonals of its squares', async () => {
    const mountains = walks(await parsed(cubeResult()), 'fold-mountain');
    expect(mountains).toHaveLength(5);
    for (const [from, to] of mountains) {
      expect(Math.hypot(from![0]! - to![0]!, from![1]! - to![1]!)).toBeCloseTo(40, 3);
    }
  });

  it('walks a slit there and back', async () => {
    const drawing = await parsed(slitResult());
    const [walk] = walks(drawing, 'cut');
    expect(walk).toHaveLength(6);
    expect(-areaOf(walk!)).toBeCloseTo(2 * 30 * 30, 1);
    const points = walk!.map((point) => point.join());
    expect(new Set(points).size).toBe(5);
    expect(walks(drawing, 'fold-valley')).toHaveLength(1);
  });

  it('leaves flat folds out by their angle', async () => {
    const folds = walks(await parsed(cubeResult(), { flatFold: 91 }), 'fold-mountain');
    expect(folds).toEqual([]);
  });

  it('tells mountains, valleys and cuts apart without colour', async () => {
    const drawing = await parsed(slitResult());
    const cut = groupOf(drawing, 'cut').path![0]!;
    const valley = groupOf(drawing, 'fold-valley').path![0]!;
    const mountain = groupOf(await parsed(cubeResult()), 'fold-mountain').path![0]!;
    expect(cut['stroke-dasharray']).toBeUndefined();
    expect(mountain['stroke-dasharray']!.split(' ')).toHaveLength(2);
    expect(valley['stroke-dasharray']!.split(' ')).toHaveLength(4);
  });

  it('walks around flaps, and folds them at their bases', async () => {
    const bare = await parsed(slitResult());
    const drawing = await parsed(flapResult());
    const without = walks(bare, 'cut')[0]!;
    const around = walks(drawing, 'cut')[0]!;
    // Foot and two corners; the other foot is the end of the edge.
    expect(around).toHaveLength(without.length + 3);
    expect(Math.abs(areaOf(around)) - Math.abs(areaOf(without))).toBeGreaterThan(0);
    const folds = walks(drawing, 'fold-valley');
    expect(folds).toHaveLength(walks(bare, 'fold-valley').length + 1);
    const [foot, end] = folds.at(-1)!;
    expect(around).toContainEqual(foot);
    expect(around).toContainEqual(end);
  });

  it('names each piece inside one of its faces', async () => {
    const [box, lid] = await allSheets(boxAndLidResult());
    expect(groupOf(box!, 'id').text!.map((label) => label['#text'])).toEqual(['A']);
    expect(groupOf(lid!, 'id').text!.map((label) => label['#text'])).toEqual(['B']);
  });

  it('turns an id about its own place', async () => {
    const result = slitResult();
    result.pieces[0]!.labels.push({ text: 'C:17', x: 20, y: 30, angle: 30, size: 2 });
    const [, id] = groupOf(await parsed(result), 'id').text!;
    expect(id!['#text']).toBe('C:17');
    const [angle, x, y] = id!.transform!.match(/-?[\d.]+/g)!.map(Number);
    expect([angle, x, y]).toEqual([-30, Number(id!.x), Number(id!.y)]);
    // Down from the middle by half a capital's height, across the baseline.
    expect(Number(id!.x)).toBeCloseTo(30 + 0.72 * 0.5, 3);
    expect(297 - Number(id!.y)).toBeCloseTo(40 - 0.72 * Math.cos(Math.PI / 6), 3);
  });

  it('keeps the format of the files', async () => {
    expectGolden('box-and-lid-1.svg', await written(boxAndLidResult()));
    expectGolden('slit.svg', await written(slitResult()));
  });
});
