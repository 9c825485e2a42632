import { describe, expect, it } from 'vitest';
import { writePdf } from '../../web/export/pdf.js';
import type { JobResult } from '../../web/model/job.js';
import { boxAndLidResult, cubeResult, flapResult, slitResult } from './fixtures.js';
import { readPdf, type PdfFile } from './pdf-file.js';
import { printOf, type PrintWishes } from './printed.js';
import type { Point } from './sheet-file.js';

function lengthOf(points: Point[], closed: boolean): number {
  const ends = closed ? [...points.slice(1), points[0]!] : points.slice(1);
  return ends.reduce((sum, [x, y], i) => {
    const [u, v] = points[i]!;
    return sum + Math.hypot(x - u, y - v);
  }, 0);
}

async function written(result: JobResult, wishes?: PrintWishes): Promise<PdfFile> {
  return readPdf(await writePdf(await printOf(result, wishes)));
}

describe('writePdf', () => {
  it('makes each sheet a page of true size that is printed unscaled', async () => {
    const { pages, scaling, title } = await written(boxAndLidResult(), { title: 'box' });
    expect(pages).toHaveLength(2);
    for (const { sheet } of pages) {
      expect(sheet.width).toBeCloseTo(210, 3);
      expect(sheet.height).toBeCloseTo(297, 3);
    }
    expect([scaling, title]).toEqual(['None', 'box']);
  });

  it('draws cuts and folds at true length', async () => {
    const { pages } = await written(cubeResult());
    const { cuts, mountains } = pages[0]!.sheet.pieces.get('A')!;
    // The cross has 14 sides of 40 mm around it.
    expect(lengthOf(cuts[0]!, true)).toBeCloseTo(14 * 40, 2);
    expect(mountains).toHaveLength(5);
    for (const fold of mountains) expect(lengthOf(fold, false)).toBeCloseTo(40, 3);
  });

  it('places pieces where the sheet has them', async () => {
    const result = cubeResult();
    const { pages } = await written(result);
    const [cut] = pages[0]!.sheet.pieces.get('A')!.cuts;
    expect(Math.min(...cut!.map(([x]) => x))).toBeCloseTo(result.pieces[0]!.x, 3);
    expect(Math.min(...cut!.map(([, y]) => y))).toBeCloseTo(result.pieces[0]!.y, 3);
  });

  it('has a layer for each kind of what it draws, and none that is empty', async () => {
    const shaded = await written(flapResult(), { options: { style: 'blender' } });
    expect(shaded.layers).toEqual(['Guide', 'Flaps', 'Valley folds', 'Numbers', 'Cuts']);
    for (const { layers } of shaded.pages)
      expect([...layers].sort()).toEqual([...shaded.layers].sort());
    const { layers, pages } = await written(boxAndLidResult());
    expect(layers).toEqual(['Guide', 'Mountain folds', 'Numbers', 'Cuts']);
    const flat = boxAndLidResult();
    flat.pieces[1]!.labels = [];
    expect((await written(flat)).pages[1]!.layers).not.toContain('Numbers');
    expect(pages[1]!.layers).toContain('Numbers');
  });

  it('walks a slit there and back', async () => {
    const { pages } = await written(slitResult());
    const [cut] = pages[0]!.sheet.pieces.get('A')!.cuts;
    expect(lengthOf(cut!, true)).toBeCloseTo(4 * 30 * Math.SQRT2 + 2 * 30, 2);
  });

  it('draws lines as they were asked for', async () => {
    const { pages } = await written(flapResult(), {
      options: {
        style: 'blender',
        legend: false,
        lines: { cut: { width: 0.5, colour: '#ff0000' }, valley: { dash: [2, 1] } },
      },
    });
    const [paint, ...more] = pages[0]!.paths.filter((path) => path.paint === 'fill');
    expect([paint!.colour, more]).toEqual(['#e6e6e6', []]);
    const cut = pages[0]!.paths.find(({ colour }) => colour === '#ff0000')!;
    expect([cut.closed, cut.dash]).toEqual([true, []]);
    expect(cut.width).toBeCloseTo(0.5, 4);
    const fold = pages[0]!.paths.find(({ dash }) => dash.length === 2)!;
    expect(fold.width).toBeCloseTo(0.2, 4);
    fold.dash.forEach((length, i) => expect(length).toBeCloseTo([2, 1][i]!, 4));
  });

  it('says what page it is, and how to print it', async () => {
    const { pages } = await written(boxAndLidResult(), { title: 'box' });
    const texts = pages.map((page) => page.texts.map(({ text }) => text));
    expect(texts[0]).toContain('box');
    expect(texts[0]).toContain('sheet 1 of 2 · print at 100 %');
    expect(texts[1]).toContain('sheet 2 of 2 · print at 100 %');
    expect(texts[0]).toContain('A');
  });

  it('embeds of its fonts only what is used', async () => {
    const bytes = await writePdf(await printOf(cubeResult()));
    // The whole of the smallest file of the fonts is larger.
    expect(bytes.length).toBeLessThan(12_000);
  });

  it('is the same bytes every time', async () => {
    const [a, b] = [cubeResult(), cubeResult()].map(async (result) =>
      writePdf(await printOf(result)),
    );
    expect(await a).toEqual(await b);
  });
});
