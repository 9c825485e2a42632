import UPNG from '@pdf-lib/upng';
import { describe, expect, it } from 'vitest';
import { writePng } from '../../web/export/png.js';
import { pixelExcess, pixelSize } from '../../web/model/pixels.js';
import type { PrintOptions } from '../../web/model/print-options.js';
import { cubeResult } from './fixtures.js';
import { fontReader, printOf } from './printed.js';

/** What another library reads of a picture. */
interface Picture {
  width: number;
  height: number;
  /** Pixels to the metre. */
  density: number;
  /** Four for each pixel. */
  colours: Uint8Array;
}

const written = async (options: Partial<PrintOptions>): Promise<Uint8Array> =>
  writePng(await printOf(cubeResult(), { options: { legend: false, ...options } }), 0);

async function picture(options: Partial<PrintOptions>): Promise<Picture> {
  const bytes = await written(options);
  const decoded = UPNG.decode(bytes.slice().buffer);
  const [across, up, unit] = (decoded.tabs as { pHYs: number[] }).pHYs;
  expect([across, unit]).toEqual([up, 1]);
  const [colours] = UPNG.toRGBA8(decoded);
  const { width, height } = decoded;
  return { width, height, density: across!, colours: new Uint8Array(colours!) };
}

/** Middles of the lines that are crossed by a row (mm from the upper edge), weighed by their ink. */
function linesAcross({ width, colours, density }: Picture, y: number): number[] {
  const row = Math.floor((y / 1000) * density);
  const middles: number[] = [];
  let [ink, moment] = [0, 0];
  for (let x = 0; x <= width; ++x) {
    const dark = x < width ? 255 - colours[4 * (row * width + x)]! : 0;
    ink += dark;
    moment += dark * (x + 0.5);
    if (dark > 0 || ink === 0) continue;
    middles.push((1000 * moment) / ink / density);
    [ink, moment] = [0, 0];
  }
  return middles;
}

describe('writePng', () => {
  it.each([72, 300, 600])('has true size at %i dots per inch', async (dpi) => {
    const { width, height, density } = await picture({ dpi });
    expect([width, height]).toEqual([Math.ceil((210 / 25.4) * dpi), Math.ceil((297 / 25.4) * dpi)]);
    expect(Math.abs((density * 25.4) / 1000 - dpi)).toBeLessThan(0.02);
    // The sheet and less than one dot beyond it, by what the file says.
    expect((1000 * width) / density - 210).toBeGreaterThan(-0.01);
    expect((1000 * width) / density - 210).toBeLessThan(25.4 / dpi + 0.01);
  });

  it('draws lines where they are within 0.01 mm', async () => {
    const { x, y } = cubeResult().pieces[0]!;
    const page = await picture({ dpi: 600 });
    // Through the sides: two cuts, and the three folds between them; no letters are there.
    const found = linesAcross(page, 297 - (y + 50)).filter((at) => at > x - 1);
    expect(found).toHaveLength(5);
    found.forEach((at, i) => expect(Math.abs(at - (x + 40 * i))).toBeLessThan(0.01));
  });

  it('is white paper with letters drawn from the fonts that come along', async () => {
    const { colours, width } = await picture({ dpi: 300 });
    expect([...colours.subarray(0, 4)]).toEqual([255, 255, 255, 255]);
    for (let i = 3; i < colours.length; i += 4) if (colours[i] !== 255) throw new Error('a hole');
    const loaded: string[] = [];
    const print = await printOf(cubeResult(), { loadFont: fontReader(loaded) });
    await writePng(print, 0);
    expect(loaded).toEqual(['noto-sans-latin-400-normal.woff']);
    // The name of the piece: ink in the middle of one of its faces.
    const { x, y, labels } = cubeResult().pieces[0]!;
    const middle = [x + labels[0]!.x, 297 - (y + labels[0]!.y)].map((mm) =>
      Math.round((mm / 25.4) * 300),
    );
    let ink = 0;
    for (let dy = -25; dy <= 25; ++dy) {
      for (let dx = -25; dx <= 25; ++dx) {
        if (colours[4 * ((middle[1]! + dy) * width + middle[0]! + dx)]! < 128) ++ink;
      }
    }
    expect(ink).toBeGreaterThan(200);
  });

  it('draws the colours of machines', async () => {
    const { colours } = await picture({
      dpi: 300,
      machine: 'generic',
      lines: { cut: { width: 1 } },
    });
    let red = 0;
    for (let i = 0; i < colours.length; i += 4) {
      if (colours[i] === 255 && colours[i + 1] === 0 && colours[i + 2] === 0) ++red;
    }
    expect(red).toBeGreaterThan(1000);
  });

  it('gives the same bytes every time', async () => {
    expect(await written({ dpi: 150 })).toEqual(await written({ dpi: 150 }));
  });

  it('refuses more pixels than can be drawn, and says what can', async () => {
    const large = cubeResult();
    large.sheets = [{ width: 420, height: 594 }];
    const print = await printOf(large, { options: { dpi: 1200 } });
    await expect(writePng(print, 0)).rejects.toThrow(
      '1200 dots per inch are too many for sheets of 420 x 594 mm: 622 are possible',
    );
  });
});

describe('pixelExcess', () => {
  it('takes A4 at any resolution, and what it says is possible', () => {
    expect(pixelExcess(210, 297, 1200)).toBeNull();
    for (const side of [300, 1000, 5000]) {
      const most = pixelExcess(side, side, 1200)?.possible ?? 1200;
      expect(pixelExcess(side, side, most)).toBeNull();
    }
    expect(pixelSize(25.4, 50.8, 100)).toEqual({ width: 100, height: 200 });
  });
});
