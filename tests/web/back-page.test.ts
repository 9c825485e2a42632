/** Sheets that are printed on both sides. */
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { writePdf } from '../../web/export/pdf.js';
import type { SheetDrawing } from '../../web/export/sheet-drawing.js';
import { writeSvg } from '../../web/export/svg.js';
import type { JobResult } from '../../web/model/job.js';
import type { PrintOptions } from '../../web/model/print-options.js';
import { inFolder } from './command.js';
import { boxAndLidResult, cubeResult, flapResult } from './fixtures.js';
import { readPdf, type PdfPage } from './pdf-file.js';
import { printOf } from './printed.js';
import type { Point } from './sheet-file.js';

async function pagesOf(result: JobResult, options: Partial<PrintOptions> = {}): Promise<PdfPage[]> {
  const print = await printOf(result, { options: { duplex: true, ...options } });
  return (await readPdf(await writePdf(print))).pages;
}

const sorted = (lines: Point[][]): number[][] =>
  lines
    .map((line) => line.flat().map((value) => Math.round(1000 * value)))
    .sort((a, b) => a.join().localeCompare(b.join()));

const foldsOf = ({ sheet }: PdfPage, kind: 'mountains' | 'valleys'): Point[][] =>
  [...sheet.pieces.values()].flatMap((piece) => piece[kind]);

/** The crosses: the only lines of the guide that are 4 mm long. */
function crossesOf({ frame }: SheetDrawing): Point[][] {
  return frame.strokes
    .map(({ points }) => points)
    .filter((points) => {
      const [from, to] = points;
      return points.length === 2 && Math.hypot(to![0] - from![0], to![1] - from![1]) === 4;
    });
}

function turned({ width, height }: { width: number; height: number }, lines: Point[][]): Point[][] {
  const turn = ([x, y]: Point): Point => (width > height ? [x, height - y] : [width - x, y]);
  return lines.map((line) => line.map(turn));
}

/** The box and its lid on paper of this size. */
function onPaper(width: number, height: number): JobResult {
  const result = boxAndLidResult();
  return { ...result, sheets: result.sheets.map(() => ({ width, height })) };
}

describe('backs of sheets', () => {
  it.each([
    ['upright', 210, 297],
    ['sideways', 297, 210],
    ['square', 250, 250],
  ])('have the folds behind those of the front, on paper %s', async (_, width, height) => {
    const pages = await pagesOf(onPaper(width, height));
    expect(pages).toHaveLength(4);
    for (const i of [0, 2]) {
      const [front, back] = [pages[i]!, pages[i + 1]!];
      const mountains = foldsOf(front, 'mountains');
      // The box has its folds on the first sheet, the lid has none.
      expect(mountains.length > 0).toBe(i === 0);
      // What is a mountain from the front is a valley from the back.
      expect(sorted(foldsOf(back, 'valleys'))).toEqual(
        sorted(turned({ width, height }, mountains)),
      );
      expect(sorted(foldsOf(back, 'mountains'))).toEqual(
        sorted(turned({ width, height }, foldsOf(front, 'valleys'))),
      );
      for (const { cuts, texts } of back.sheet.pieces.values()) {
        expect([cuts, texts]).toEqual([[], []]);
      }
      const words = back.texts.map(({ text }) => text).join('\n');
      expect(words).toContain(`back of sheet ${i / 2 + 1} of 2 · this side is inside`);
      expect(words).toContain('turned along the long edge');
    }
  });

  it.each([
    [210, 297, 10],
    [297, 210, 10],
    [148, 210, 5],
    [210, 148, 0],
  ])('have crosses where the front has them: %d x %d, margin %d', async (width, height, margin) => {
    const options = { duplex: true };
    const { backs, sheets } = await printOf(onPaper(width, height), { options, margin });
    backs.forEach((back, i) => {
      const front = crossesOf(sheets[i]!);
      expect(front).toHaveLength(4);
      expect(sorted(crossesOf(back))).toEqual(sorted(turned(back, front)));
      for (const { at, text } of [...back.frame.texts, ...sheets[i]!.frame.texts]) {
        const near = (points: Point[]): boolean =>
          points.every(([x, y]) => Math.hypot(x - at[0], y - at[1]) < 3);
        expect(crossesOf(back).some(near), text).toBe(false);
      }
    });
  });

  it('begin on a front after pages that tell how to build the model', async () => {
    const pages = await pagesOf(boxAndLidResult(), { assembly: true });
    // Three pages, and one that stays blank.
    expect(pages).toHaveLength(3 + 1 + 2 * 2);
    expect([pages[3]!.paths, pages[3]!.texts]).toEqual([[], []]);
    expect(pages[4]!.texts.map(({ text }) => text).join()).toContain('sheet 1 of 2 · print at');
    const even = await pagesOf(cubeResult(), { assembly: true });
    expect(even).toHaveLength(2 + 2);
  });

  it('have whole folds where the front has ticks, as long as a printer needs', async () => {
    const measured: [number, number] = [49, 51];
    const print = await printOf(cubeResult(), {
      options: { duplex: true, foldTicks: true, measured },
    });
    const [back] = print.backs;
    const [piece] = back!.pieces;
    expect(piece!.valleys).toHaveLength(5);
    const [[x, y], [u, v]] = piece!.valleys[0]!;
    expect(Math.hypot(((u - x) * 49) / 50, ((v - y) * 51) / 50)).toBeCloseTo(40, 6);
    expect(print.sheets[0]!.pieces[0]!.mountains).toHaveLength(10);
  });

  it('are in no other format, and not for machines', async () => {
    const print = await printOf(flapResult(), { options: { duplex: true } });
    expect(writeSvg(print, 0)).not.toContain('back of');
    const { backs } = await printOf(flapResult(), { options: { duplex: true, machine: 'cricut' } });
    expect(backs).toEqual([]);
  });

  it('tell the print dialogue to turn along the long edge', async () => {
    const plain = await writePdf(await printOf(cubeResult()));
    const double = await writePdf(await printOf(cubeResult(), { options: { duplex: true } }));
    await inFolder((folder) => {
      const text = (bytes: Uint8Array): string => {
        const file = join(folder, 'out.pdf');
        writeFileSync(file, bytes);
        expect(execFileSync('qpdf', ['--check', file], { encoding: 'utf8' })).toContain(
          'No syntax',
        );
        return execFileSync('qpdf', ['--qdf', '--object-streams=disable', file, '-'], {
          encoding: 'latin1',
        });
      };
      expect(text(double)).toContain('/Duplex /DuplexFlipLongEdge');
      expect(text(plain)).not.toContain('/Duplex');
      return Promise.resolve();
    });
  });
});
