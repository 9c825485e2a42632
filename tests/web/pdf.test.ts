import { describe, expect, it } from 'vitest';
import { writePdf } from '../../web/export/pdf.js';
import { boxAndLidResult, cubeResult, slitResult } from './fixtures.js';
import { readPdf, type PdfLine } from './pdf-lines.js';

function lengthOf({ points }: PdfLine): number {
  return points.slice(1).reduce((sum, [x, y], i) => {
    const [u, v] = points[i]!;
    return sum + Math.hypot(x! - u!, y! - v!);
  }, 0);
}

/** Closed walks of the cut style; the ruler's lines are open. */
const cutsOf = (lines: PdfLine[]) =>
  lines.filter(({ points }) => points.length > 2 && points.at(-1)!.join() === points[0]!.join());

describe('writePdf', () => {
  it('makes each sheet a page of true size that is printed unscaled', async () => {
    const { pages, scaling } = await readPdf(await writePdf(boxAndLidResult(), { title: 'box' }));
    expect(pages).toHaveLength(2);
    for (const page of pages) {
      expect(page.width).toBeCloseTo(210, 3);
      expect(page.height).toBeCloseTo(297, 3);
    }
    expect(scaling).toBe('None');
  });

  it('draws cuts and folds at true length', async () => {
    const { pages } = await readPdf(await writePdf(cubeResult(), { title: 'cube' }));
    const [cut] = cutsOf(pages[0]!.lines);
    // The cross has 14 sides of 40 mm around it.
    expect(lengthOf(cut!)).toBeCloseTo(14 * 40, 2);
    expect(cut!.dash).toEqual([]);
    const folds = pages[0]!.lines.filter(({ dash }) => dash.length === 2);
    expect(folds).toHaveLength(5);
    for (const fold of folds) expect(lengthOf(fold)).toBeCloseTo(40, 3);
  });

  it('places pieces where the sheet has them', async () => {
    const result = cubeResult();
    const { pages } = await readPdf(await writePdf(result, { title: 'cube' }));
    const [cut] = cutsOf(pages[0]!.lines);
    expect(Math.min(...cut!.points.map(([x]) => x!))).toBeCloseTo(result.pieces[0]!.x, 3);
    expect(Math.min(...cut!.points.map(([, y]) => y!))).toBeCloseTo(result.pieces[0]!.y, 3);
  });

  it('walks a slit there and back', async () => {
    const { pages } = await readPdf(await writePdf(slitResult(), { title: 'slit' }));
    const [cut] = cutsOf(pages[0]!.lines);
    expect(lengthOf(cut!)).toBeCloseTo(4 * 30 * Math.SQRT2 + 2 * 30, 2);
  });

  it('says what page it is and draws a ruler of 50 mm', async () => {
    const { pages } = await readPdf(await writePdf(boxAndLidResult(), { title: 'box' }));
    expect(pages[0]!.text).toContain('box - sheet 1 of 2 - print at 100 %');
    expect(pages[1]!.text).toContain('box - sheet 2 of 2 - print at 100 %');
    expect(pages[0]!.text).toContain('50 mm');
    expect(pages[0]!.text).toContain('A');
    const ruler = pages[0]!.lines.filter((line) => Math.abs(lengthOf(line) - 50) < 1e-3);
    expect(ruler).toHaveLength(1);
  });

  it('leaves notes out where the margin is too narrow for them', async () => {
    const { pages } = await readPdf(await writePdf(cubeResult(), { title: 'cube', margin: 3 }));
    expect(pages[0]!.text).toEqual(['A']);
  });

  it('replaces letters that the standard fonts lack', async () => {
    const { pages } = await readPdf(await writePdf(cubeResult(), { title: 'K\u00e4se \u6298' }));
    expect(pages[0]!.text).toContain('K\u00e4se ? - sheet 1 of 1 - print at 100 %');
  });

  it('is the same bytes every time', async () => {
    const [a, b] = [cubeResult(), cubeResult()].map((result) =>
      writePdf(result, { title: 'cube' }),
    );
    expect(await a).toEqual(await b);
  });
});
