/** Numbers that could be read upside down, in every format. */
import UPNG from '@pdf-lib/upng';
import DxfParser, { type ILineEntity } from 'dxf-parser';
import { describe, expect, it } from 'vitest';
import { writeDxf } from '../../web/export/dxf.js';
import { writePdf } from '../../web/export/pdf.js';
import { writePng } from '../../web/export/png.js';
import { writeSvg } from '../../web/export/svg.js';
import type { PrintOptions } from '../../web/model/print-options.js';
import { cubeResult } from './fixtures.js';
import { readPdf } from './pdf-file.js';
import { printOf } from './printed.js';

/** The piece of a cube with this number on its middle, 6 mm high; the sheet has no other. */
function numbered(text: string, options: Partial<PrintOptions> = {}) {
  const result = cubeResult();
  const [piece] = result.pieces;
  piece!.labels = [{ ...piece!.labels[0]!, text }];
  return printOf(result, { options });
}

function darkPixels(png: Uint8Array): number {
  const picture = UPNG.decode(png.slice().buffer);
  const values = new Uint8Array(UPNG.toRGBA8(picture)[0]!);
  return values.filter((value, i) => i % 4 === 0 && value < 160).length;
}

/** Lines among the numbers: letters are texts or have more points. */
const linesIn = (svg: string): string[] => {
  const [numbers] = /<g id="id".*?<\/g>/s.exec(svg)!;
  return numbers.match(/<path [^>]*d="M[\d.]+ [\d.]+L[\d.]+ [\d.]+"\/>/g) ?? [];
};

describe('numbers that read as others upside down', () => {
  it('have a line below them as SVG, and others have none', async () => {
    const lines = linesIn(writeSvg(await numbered('68'), 0));
    expect(lines).toHaveLength(1);
    expect(lines[0]).toContain('data-piece="A" fill="none" stroke="#333333"');
    for (const text of ['69', '12', 'A6']) {
      expect(linesIn(writeSvg(await numbered(text), 0))).toEqual([]);
    }
  });

  it('have it in the pen’s colour for machines', async () => {
    const lines = linesIn(writeSvg(await numbered('68', { machine: 'generic' }), 0));
    expect(lines).toHaveLength(1);
    expect(lines[0]).toContain('stroke="#ff00ff" stroke-width="0.1"');
  });

  it('have it in the layer of numbers as PDF and DXF', async () => {
    const count = async (text: string): Promise<number> => {
      const { pages } = await readPdf(await writePdf(await numbered(text)));
      return pages[0]!.paths.length;
    };
    expect((await count('68')) - (await count('12'))).toBe(1);

    const dxf = new DxfParser().parseSync(await writeDxf(await numbered('68'), 0))!;
    const lines = dxf.entities.filter(({ layer, type }) => layer === 'TEXT' && type === 'LINE');
    expect(lines).toHaveLength(1);
    const [from, to] = (lines[0] as ILineEntity).vertices;
    expect(from!.y).toBe(to!.y);
    expect(to!.x - from!.x).toBeGreaterThan(4);
  });

  it('have it in pictures', async () => {
    const print = await numbered('6', { dpi: 72 });
    const [sheet] = print.sheets;
    const pieces = sheet!.pieces.map((piece) => ({
      ...piece,
      texts: piece.texts.map((text) => ({ ...text, underlined: false })),
    }));
    const bare = { ...print, sheets: [{ ...sheet!, pieces }] };
    const [dark, less] = [
      darkPixels(await writePng(print, 0)),
      darkPixels(await writePng(bare, 0)),
    ];
    // 2.8 mm times 0.35 mm at 72 dots per inch.
    expect(dark - less).toBeGreaterThan(5);
    expect(dark - less).toBeLessThan(20);
  });

  it('are told in the legend', async () => {
    const words = 'number with a line: the line is below';
    expect(writeSvg(await numbered('6'), 0)).toContain(words);
    expect(writeSvg(await numbered('8'), 0)).not.toContain(words);
  });
});
