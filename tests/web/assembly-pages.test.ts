import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { buildingPlan } from '../../web/export/building-plan.js';
import { writePdf } from '../../web/export/pdf.js';
import { writeFiles } from '../../web/export/files.js';
import type { DrawnFormat } from '../../web/export/formats.js';
import { pagesOf, type Print } from '../../web/export/print.js';
import type { SheetDrawing } from '../../web/export/sheet-drawing.js';
import { writeSvg } from '../../web/export/svg.js';
import { capHeight, widthAtMost } from '../../web/export/text-line.js';
import { cutPairs } from '../../web/model/borders.js';
import type { JobResult } from '../../web/model/job.js';
import { inFolder } from './command.js';
import { engineResult } from './engine-result.js';
import { beakResult, boxAndLidResult, cubeResult, slitResult } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { readPdf } from './pdf-file.js';
import { printOf } from './printed.js';
import { isEngineBuilt } from './thread-pool.js';

const withPages = (result: JobResult, title = 'cube'): Promise<Print> =>
  printOf(result, { title, options: { assembly: true } });

/** Names of the files in a format. */
async function namesOf(format: DrawnFormat, print: Print): Promise<string[]> {
  const files = await writeFiles(format, {
    result: boxAndLidResult(),
    print,
    name: `box.${format}`,
  });
  return files.map(({ name }) => name);
}

const textsOf = ({ frame }: SheetDrawing): string[] => frame.texts.map(({ text }) => text);

const ringResult = (parts: number): Promise<JobResult> =>
  engineResult(objText(wavyRing(10)), { parts, paperWidth: 148, paperHeight: 210 });

/** Boxes of texts, as far as their letters reach. */
function boxesOf({ frame }: SheetDrawing) {
  return frame.texts.map(({ text, at, anchor, size }) => {
    // Letters are narrower than they may be.
    const width = 0.8 * widthAtMost(text, size);
    const left = anchor === 'middle' ? at[0] - width / 2 : at[0];
    return { text, left, right: left + width, bottom: at[1], top: at[1] + capHeight * size };
  });
}

function overlaps(page: SheetDrawing): string[] {
  const boxes = boxesOf(page);
  return boxes.flatMap((a, i) =>
    boxes
      .slice(i + 1)
      .filter((b) => a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top)
      .map((b) => `${a.text} on ${b.text}`),
  );
}

/** Texts and pictures that leave the page, or come closer to its edge than a printer goes. */
function outside(page: SheetDrawing): string[] {
  const least = 4;
  const texts = boxesOf(page).filter(
    ({ left, right, bottom, top }) =>
      left < least || right > page.width - least || bottom < least || top > page.height - least,
  );
  const points = page.picture!.flatMap(({ walks }) => walks.flat());
  const strays = points.filter(
    ([x, y]) => x < least || y < least || x > page.width - least || y > page.height - least,
  );
  return [...texts.map(({ text }) => text), ...strays.map(String)];
}

describe('pages that tell how to build a model', () => {
  it('are there only if they are asked for', async () => {
    expect((await printOf(cubeResult())).pages).toEqual([]);
    const { pages, sheets } = await withPages(cubeResult());
    // A single piece needs no list.
    expect([pages.length, sheets.length]).toEqual([2, 1]);
    expect((await withPages(boxAndLidResult())).pages).toHaveLength(3);
  });

  it('tell on the cover what a person wants to know', async () => {
    const { pages } = await withPages(boxAndLidResult(), 'my box');
    expect(textsOf(pages[0]!)).toEqual(
      expect.arrayContaining([
        'my box',
        '40 mm wide, 40 mm high, 40 mm deep',
        '2 pieces on 2 sheets of 210 × 297 mm',
        '4 mountain folds, no valley folds',
        '8 seams',
        'about 15 minutes',
        'about 10 minutes',
        'All folds are mountains.',
        'A',
        'B',
      ]),
    );
  });

  it('list every piece once, with its sheet', async () => {
    const { pages } = await withPages(boxAndLidResult());
    const texts = textsOf(pages[1]!);
    for (const [piece, name] of ['A', 'B'].entries()) {
      expect(texts.filter((text) => text === name)).toHaveLength(1);
      expect(texts.filter((text) => text === `on sheet ${piece + 1}`)).toHaveLength(1);
    }
  });

  it('have a step for every piece, in the order of gluing', async () => {
    const { pages } = await withPages(boxAndLidResult());
    const titles = textsOf(pages[2]!).filter((text) => text.startsWith('Step '));
    expect(titles).toEqual(['Step by step', 'Step 1: piece A', 'Step 2: piece B']);
  });

  it.each([
    ['cube', cubeResult],
    ['box and lid', boxAndLidResult],
    ['beak', beakResult],
    ['slit', slitResult],
  ])('join every pair of edges once: %s', (_, make) => {
    const result = make();
    const { seams, steps } = buildingPlan(result, 3);
    const edges = steps
      .flatMap(({ closed, glued }) => [...closed, ...glued])
      .map(([{ edge, piece }]) => result.pieces[piece]!.modelEdges[edge]!);
    expect(new Set(edges).size).toBe(edges.length);
    expect(edges).toHaveLength(cutPairs(result.pieces).length);
    expect(seams).toBe(edges.length);
  });

  it.each([
    ['all pictures', 0, [true, true]],
    ['a list with pictures, steps without', 70_000, [true, false]],
    ['pictures on the cover alone', 150_000, [false, false]],
  ])('have %s where the model has %d more faces', async (_, more, expected) => {
    const result = boxAndLidResult();
    const { model } = result;
    // Of no piece, and so never drawn: they count alone.
    const faces = new Int32Array(model.faces.length + 3 * more);
    faces.set(model.faces);
    const { pages } = await withPages({ ...result, model: { ...model, faces } });
    const grey = ({ picture }: SheetDrawing): boolean =>
      picture!.some(
        (shape) =>
          shape.kind === 'area' &&
          /^#(..)\1\1$/.test(shape.colour) &&
          shape.colour !== '#ffffff' &&
          shape.colour !== '#222222',
      );
    expect(pages.slice(1).map(grey)).toEqual(expected);
    expect(pages[0]!.picture!.some(({ kind }) => kind === 'area')).toBe(true);
  });

  it('are the same bytes every time', async () => {
    const write = async () => writePdf(await withPages(boxAndLidResult()));
    expect(await write()).toEqual(await write());
    const svg = async () => writeSvg(pagesOf(await withPages(boxAndLidResult())), 1);
    expect(await svg()).toEqual(await svg());
  });

  it('come before the sheets in a PDF, and beside them as SVG', async () => {
    const print = await withPages(boxAndLidResult());
    const { pages } = await readPdf(await writePdf(print));
    expect(pages).toHaveLength(5);
    expect(pages[0]!.texts.map(({ text }) => text)).toContain('How to build it');
    expect(pages[3]!.texts.map(({ text }) => text)).toContain('sheet 1 of 2 · print at 100 %');
    expect(await namesOf('svg', print)).toEqual([
      'box-1.svg',
      'box-2.svg',
      'box-building-1.svg',
      'box-building-2.svg',
      'box-building-3.svg',
    ]);
    expect(writeSvg(pagesOf(print), 0)).toContain('How to build it');
  });

  it('are files of their own beside sheets for a machine, and look as for people', async () => {
    const options = { assembly: true, machine: 'generic' } as const;
    const print = await printOf(boxAndLidResult(), { options });
    expect(await namesOf('pdf', print)).toEqual(['box-1.pdf', 'box-2.pdf', 'box-building.pdf']);
    expect(await namesOf('dxf', print)).toEqual(['box-1.dxf', 'box-2.dxf']);
    const people = pagesOf(await withPages(boxAndLidResult()));
    expect(pagesOf(print).sheets).toEqual(people.sheets);
    expect(writeSvg(pagesOf(print), 0)).toBe(writeSvg(people, 0));
  });

  it('have the letters of any name', async () => {
    const result = boxAndLidResult();
    result.pieces[1]!.name = 'くじら';
    const print = await withPages(result, '<b>"& 折り紙');
    expect(print.notices).toEqual([]);
    const { pages } = await readPdf(await writePdf(print));
    const words = pages[0]!.texts.map(({ text }) => text).join('');
    expect(words).toContain('くじら');
    expect(words).toContain('<b>"& 折り紙');
    expect(writeSvg(pagesOf(print), 0)).not.toContain('<b>');
  });

  it('are well formed', async () => {
    const bytes = await writePdf(await withPages(boxAndLidResult()));
    await inFolder((folder) => {
      const file = join(folder, 'out.pdf');
      writeFileSync(file, bytes);
      const said = execFileSync('qpdf', ['--check', file], { encoding: 'utf8' });
      expect(said).toContain('No syntax or stream encoding errors found');
      return Promise.resolve();
    });
  });

  it.each([
    [210, 297],
    [297, 210],
    [148, 210],
    [304.8, 304.8],
    [90, 400],
    [20, 20],
  ])('keep to paper of %d x %d mm', async (width, height) => {
    const result = boxAndLidResult();
    const paper = { ...result, sheets: result.sheets.map(() => ({ width, height })) };
    const { pages } = await printOf(paper, { margin: 5, options: { assembly: true } });
    for (const page of pages) {
      expect([page.width, page.height]).toEqual([width, height]);
      expect(overlaps(page)).toEqual([]);
      if (Math.min(width, height) > 80) expect(outside(page)).toEqual([]);
    }
  });
});

describe.skipIf(!isEngineBuilt)('pages of a model with many pieces', () => {
  it('hold every piece and every seam, and keep texts apart', async () => {
    const result = await ringResult(24);
    const { pages } = await withPages(result, 'ring');
    const { length } = result.pieces;
    expect(length).toBeGreaterThanOrEqual(24);
    const texts = pages.slice(1).flatMap(textsOf);
    for (const { name } of result.pieces) {
      expect(texts.filter((text) => text === name)).toHaveLength(1);
      expect(texts.filter((text) => text.endsWith(`: piece ${name}`))).toHaveLength(1);
    }
    const { steps } = buildingPlan(result, 3);
    const edges = steps
      .flatMap(({ closed, glued }) => [...closed, ...glued])
      .map(([{ edge, piece }]) => result.pieces[piece]!.modelEdges[edge]!);
    expect(new Set(edges).size).toBe(edges.length);
    expect(edges).toHaveLength(cutPairs(result.pieces).length);
    for (const page of pages) {
      expect(overlaps(page)).toEqual([]);
      expect(outside(page)).toEqual([]);
    }
  });

  it('name every piece on the cover that can be seen from one of its sides', async () => {
    const result = await ringResult(12);
    const { pages } = await withPages(result, 'ring');
    const texts = textsOf(pages[0]!);
    for (const { name } of result.pieces) expect(texts).toContain(name);
  });
});
