/** PDF files as other programs see them. */
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { writePdf } from '../../web/export/pdf.js';
import { inFolder } from './command.js';
import { flapResult } from './fixtures.js';
import { Pixels, type Stretch } from './pixels.js';
import { printOf, type PrintWishes } from './printed.js';

const written = async (wishes: PrintWishes) => writePdf(await printOf(flapResult(), wishes));

const middle = ({ from, to }: Stretch): number => (from + to) / 2;

// Three dots of the picture.
const tolerance = 0.13;

/** Middles of the lines that are crossed at some height (or distance), in a part of it. */
function marks(stretches: Stretch[], from: number, to: number): number[] {
  return stretches.map(middle).filter((at) => at > from && at < to);
}

function expectLength(places: number[], length: number): void {
  expect(Math.abs(places.at(-1)! - places[0]! - length)).toBeLessThan(tolerance);
}

const titles = ['whale', '<script>"&', '折り紙のくじら', 'whale 🐳 👩‍🚀', 'Ťažký wieloryb кит'];

describe('a page as poppler renders it', () => {
  it('has rulers and a box that measure right', async () => {
    const page = await Pixels.render(await written({ margin: 10 }), 1);
    // 2.5 mm below a ruler's line only the marks of whole centimetres are left.
    const across = marks(page.across(9 - 2.5), 9, 61);
    expect(across).toHaveLength(6);
    expectLength(across, 50);
    const up = marks(page.up(4.5 + 2.5), 9, 61);
    expect(up).toHaveLength(6);
    expectLength(up, 50);
    // Through the box beside the letters in it.
    const sides = marks(page.across(5), 65, 93);
    expect(sides).toHaveLength(2);
    expectLength(sides, 20);
    const [left] = sides;
    const ends = marks(page.up(left! + 1), 0, 10);
    expect(ends).toHaveLength(2);
    expectLength(ends, 5);
  });

  it('is corrected for a printer by what its rulers measure', async () => {
    const measured = [49.5, 50.4] as const;
    const page = await Pixels.render(await written({ options: { measured } }), 1);
    // The sheet grows about its middle.
    const [x, y] = [105 - 95 * (50 / 49.5), 148.5 - (148.5 - 6.5) * (50 / 50.4)];
    expectLength(marks(page.across(y), x - 1, x + 52), 50 * (50 / 49.5));
  });
});

describe('a PDF', () => {
  it.each(titles)('is well formed and says its title: %s', async (title) => {
    const bytes = await written({ title });
    await inFolder((folder) => {
      const file = join(folder, 'out.pdf');
      writeFileSync(file, bytes);
      const said = execFileSync('qpdf', ['--check', file], { encoding: 'utf8' });
      expect(said).toContain('No syntax or stream encoding errors found');
      const text = execFileSync('pdftotext', [file, '-'], { encoding: 'utf8' });
      expect(text.replace(/\s/g, '')).toContain(
        title.replace(/[\p{Extended_Pictographic}\u200d\s]/gu, ''),
      );
      const fonts = execFileSync('pdffonts', [file], { encoding: 'utf8' }).trim().split('\n');
      for (const font of fonts.slice(2)) expect(font).toMatch(/TrueType.* yes yes yes /);
      return Promise.resolve();
    });
  });
});
