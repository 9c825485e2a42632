/** The light of surfaces, and how it comes onto the paper of simplified models. */
import { readFile } from 'node:fs/promises';
import { describe, expect, it } from 'vitest';
import { makeDoor } from '../../web/api/door.js';
import type { Options } from '../../web/api/written-options.js';
import { shadeAt, shadesOf } from '../../web/export/texture/shading.js';
import { NearestFace } from '../../web/model/nearest-face.js';
import type { JobResult } from '../../web/model/job.js';
import { partRgb } from '../../web/model/part-colours.js';
import type { PrintOptions } from '../../web/model/print-options.js';
import { writeSvg } from '../../web/export/svg.js';
import { cubeResult } from './fixtures.js';
import { colouredCube, sideColours } from './looked-cube.js';
import { printOf, readRenderer } from './printed.js';
import { imagesOf, type SheetImage } from './sheet-images.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

/** A square sheet of 2 x 2 with a groove along z in its middle, so wide and so deep; y is up. */
function grooved(width: number, depth: number): { vertices: Float64Array; faces: Int32Array } {
  const steps = 80;
  const heightAt = (x: number): number => -depth * Math.exp(-((x / width) ** 2));
  const vertices: number[] = [];
  const faces: number[] = [];
  for (let i = 0; i <= steps; ++i) {
    for (let j = 0; j <= steps; ++j) {
      const [x, z] = [(2 * i) / steps - 1, (2 * j) / steps - 1];
      vertices.push(x, heightAt(x), z);
      if (i === steps || j === steps) continue;
      const at = i * (steps + 1) + j;
      faces.push(at, at + 1, at + steps + 2, at, at + steps + 2, at + steps + 1);
    }
  }
  return { vertices: Float64Array.from(vertices), faces: Int32Array.from(faces) };
}

/** The mean shade of the faces whose middles lie within a range of x. */
function meanShade(surface: ReturnType<typeof grooved>, from: number, to: number): number {
  const shades = shadesOf(surface);
  const found: number[] = [];
  for (let face = 0; face < surface.faces.length / 3; ++face) {
    const corners = [0, 1, 2].map((i) => surface.vertices[3 * surface.faces[3 * face + i]!]!);
    const x = (corners[0]! + corners[1]! + corners[2]!) / 3;
    if (x >= from && x <= to) found.push(shadeAt(shades, face, 1 / 3, 1 / 3));
  }
  expect(found.length).toBeGreaterThan(10);
  return found.reduce((sum, shade) => sum + shade, 0) / found.length;
}

describe('shadesOf', () => {
  it('leaves the faces of a box flat, and brighter the more they look to the light', () => {
    const { model } = cubeResult();
    const shades = shadesOf(model);
    for (let face = 0; face < 12; ++face) {
      const [a, b, c] = shades.subarray(3 * face, 3 * face + 3);
      expect([b, c]).toEqual([a, a]);
    }
    // With y up the second and the first axis of the fixture: back above, front below.
    const of = (side: number): number => shades[6 * side]!;
    expect(of(4)).toBeGreaterThan(of(2) + 0.3);
    for (const shade of shades) {
      expect(shade).toBeGreaterThanOrEqual(0.35);
      expect(shade).toBeLessThanOrEqual(1);
    }
  });

  it('makes a groove darker than the surface around it, and a narrow one darker than a wide one', () => {
    const around = meanShade(grooved(0.04, 0.1), -0.9, -0.5);
    const within = (width: number): number => meanShade(grooved(width, 0.1), -0.03, 0.03);
    expect(within(0.04)).toBeLessThan(around - 0.1);
    expect(within(0.04)).toBeLessThan(within(0.6) - 0.1);
  });
});

describe('the way to a surface', () => {
  it('is that to its nearest point, whichever way faces look, and ends where it is told', () => {
    const nearest = new NearestFace(grooved(0.1, 0));
    expect(nearest.distance([0.3, 0.25, -0.4], 1)).toBeCloseTo(0.25);
    expect(nearest.distance([0.3, -0.25, -0.4], 1)).toBeCloseTo(0.25);
    expect(nearest.distance([0.3, 0.25, -0.4], 0.1)).toBe(0.1);
  });
});

async function imageOf(result: JobResult, options: Partial<PrintOptions>): Promise<SheetImage> {
  const print = await printOf(result, { options: { dpi: 72, shading: true, ...options } });
  return imagesOf(writeSvg(print, 0)).get(result.pieces[0]!.name)!;
}

/** The different colours of an image's dots, most frequent first. */
function coloursOf({ rgba }: SheetImage): number[][] {
  const counts = new Map<string, number>();
  for (let at = 0; at < rgba.length; at += 4) {
    if (rgba[at + 3] !== 255) continue;
    const key = rgba.subarray(at, at + 3).join();
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  return [...counts].sort(([, a], [, b]) => b - a).map(([key]) => key.split(',').map(Number));
}

describe('printed light', () => {
  const shades = [...shadesOf(cubeResult().model)].filter((_, i) => i % 6 === 0);
  const lit = (colours: readonly (readonly number[])[]): number[][] =>
    shades.map((shade, side) => colours[side]!.map((value) => Math.round(shade * value)));
  const sorted = (colours: number[][]): string[] => colours.map((colour) => colour.join()).sort();

  it('is multiplied into the colours of the model, of parts, and of paper', async () => {
    const all = (colour: readonly number[]): number[][] => shades.map(() => [...colour]);
    const expected: [JobResult, Partial<PrintOptions>, number[][]][] = [
      [colouredCube(), {}, lit(sideColours)],
      [colouredCube(), { texture: 'off' }, lit(all([255, 255, 255]))],
      [cubeResult(), {}, lit(all([255, 255, 255]))],
      [cubeResult(), { colour: 'part' }, lit(all(partRgb(cubeResult().pieces[0]!.part)))],
    ];
    for (const [result, options, colours] of expected) {
      const found = coloursOf(await imageOf(result, options));
      expect(new Set(sorted(found))).toEqual(new Set(sorted(colours)));
    }
  });

  it('is on no sheets for machines that would burn or cut it', async () => {
    expect(await imageOf(cubeResult(), { machine: 'silhouette' })).toBeDefined();
    expect(await imageOf(cubeResult(), { machine: 'generic' })).toBeUndefined();
    expect(await imageOf(cubeResult(), { shading: false })).toBeUndefined();
  });

  it('waits for the surface before the model was simplified', async () => {
    const simplified = { ...cubeResult(), deviation: 0.5 };
    expect(await imageOf(simplified, {})).toBeUndefined();
    expect(await imageOf({ ...simplified, original: simplified.model }, {})).toBeDefined();
  });
});

describe.skipIf(!isEngineBuilt)('a session with printed light', () => {
  const options: Options = { faces: 60, runs: 4, folding: 'off', compact: 'off', dpi: 72 };
  // Without its colours.
  const address = new URL('../../dist/studio/samples/knot.obj', import.meta.url);
  const loadFont = (): Promise<never> => Promise.reject(new Error('not needed here'));

  it('has the surface as it was before it was simplified, at the size of the sheets', () =>
    withThreads(1, async (pool) => {
      const text = (await readFile(address, 'utf8')).replace(/^(?:mtllib|usemtl).*$/gm, '');
      const files = [{ name: 'knot.obj', bytes: new TextEncoder().encode(text) }];
      const door = makeDoor({ startPool: () => pool, loadFont, loadRenderer: readRenderer });
      const session = await door.open(files, { pool });
      await session.run(options);
      const plain = await session.result();
      expect([plain.original, plain.looks]).toEqual([undefined, undefined]);
      const svg = async (look: Options = {}): Promise<string> =>
        new TextDecoder().decode((await session.export('svg', look))[0]!.bytes);
      expect(await svg()).not.toContain('<image');
      expect(await svg({ shading: 'on' })).toContain('<image');
      await session.apply({ kind: 'print', options: { shading: 'on' } });
      const { model, original, scale } = await session.result();
      expect(original!.faces.length).toBeGreaterThan(5 * model.faces.length);
      const height = ({ vertices }: { vertices: Float64Array }): number => {
        const ys = vertices.filter((_, i) => i % 3 === 1);
        return Math.max(...ys) - Math.min(...ys);
      };
      expect(scale).toBeGreaterThan(0);
      expect(height(original!) / height(model)).toBeGreaterThan(0.97);
      expect(height(original!) / height(model)).toBeLessThan(1.1);
      expect(coloursOf([...imagesOf(await svg()).values()][0]!).length).toBeGreaterThan(20);
      session.undo();
      expect(await svg()).not.toContain('<image');
    }));
});
