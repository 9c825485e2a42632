import { XMLParser } from 'fast-xml-parser';
import { describe, expect, it } from 'vitest';
import { writePdf } from '../../web/export/pdf.js';
import { writeSvg } from '../../web/export/svg.js';
import type { JobResult } from '../../web/model/job.js';
import { cubeResult, flapResult, slitResult } from './fixtures.js';
import { readPdf } from './pdf-file.js';
import { fontReader, printOf } from './printed.js';

/** A cube whose piece has this name. */
function named(text: string): JobResult {
  const result = cubeResult();
  result.pieces[0]!.labels[0]!.text = text;
  return result;
}

/** Everything that an SVG says, as text or as outlines. */
function said(svg: string): string[] {
  const parser = new XMLParser({ ignoreAttributes: false, attributeNamePrefix: '' });
  interface Group {
    text?: { '#text': string }[];
    path?: { 'data-text'?: string }[];
  }
  const { g } = (parser.parse(svg) as { svg: { g: Group[] } }).svg;
  const list = <Item>(items: Item | Item[] | undefined): Item[] => [items ?? []].flat() as Item[];
  return g.flatMap(({ text, path }) => [
    ...list(text).map((element) => element['#text']),
    ...list(path).flatMap((element) => element['data-text'] ?? []),
  ]);
}

describe('names', () => {
  it.each(['<script>"&', "it's 100 % <b>", '折り紙のくじら', 'Ťažký кит Ω', 'e\u0301te\u0301'])(
    'are written as they are: %s',
    async (name) => {
      const print = await printOf(named(name), { title: name });
      expect(print.notices).toEqual([]);
      expect(
        said(writeSvg(print, 0)).filter((text) => text === name.normalize('NFC')),
      ).toHaveLength(2);
      const { pages, title } = await readPdf(await writePdf(print));
      expect(title).toBe(name.normalize('NFC'));
      const words = pages[0]!.texts.map(({ text }) => text).join('');
      expect(words).toContain(name.normalize('NFC'));
    },
  );

  it('have boxes where no font has a sign, and say so', async () => {
    const print = await printOf(named('A'), { title: 'cat 🐱 and 👩‍🚀 🇨🇭' });
    expect(print.notices).toEqual([
      { code: 'missing-glyphs', params: { letters: ['🐱', '👩‍🚀', '🇨🇭'] } },
    ]);
    const { pages } = await readPdf(await writePdf(print));
    expect(pages[0]!.texts.map(({ text }) => text).join('|')).toContain('cat | and ');
    expect(writeSvg(print, 0)).toContain('data-text="cat 🐱 and 👩‍🚀 🇨🇭"');
  });

  it('do not keep sheets from being drawn when fonts do not come', async () => {
    const loadFont = () => Promise.reject(new Error('offline'));
    const print = await printOf(cubeResult(), { title: 'くじら', loadFont });
    expect(print.notices.map(({ code }) => code)).toEqual(['fonts-not-loaded']);
    expect(said(writeSvg(print, 0))).toContain('くじら');
    await expect(writePdf(print)).rejects.toThrow('offline');
  });

  it('break no line and no markup', async () => {
    const print = await printOf(cubeResult(), { title: 'a\nb\u0000c"/><x>' });
    expect(said(writeSvg(print, 0))).toContain('a b c"/><x>');
  });

  it('load Japanese letters only when there are some', async () => {
    const loaded: string[] = [];
    await writePdf(await printOf(cubeResult(), { title: 'whale', loadFont: fontReader(loaded) }));
    expect(loaded).toEqual(['noto-sans-latin-400-normal.woff']);
    loaded.length = 0;
    writeSvg(await printOf(cubeResult(), { loadFont: fontReader(loaded) }), 0);
    expect(loaded).toEqual([]);
    await printOf(cubeResult(), { title: 'くじら', loadFont: fontReader(loaded) });
    expect(loaded.some((file) => file.startsWith('biz-udpgothic'))).toBe(true);
    expect(loaded.length).toBeLessThan(5);
  });
});

describe('a name beside its piece', () => {
  const beside = (): JobResult => {
    const result = cubeResult();
    const [piece] = result.pieces;
    // In the lower right corner, where the legend would go.
    const name = { text: 'A', x: 175, y: 7, angle: 0, size: 2.5 };
    piece!.labels = [{ ...name, isBeside: true, leader: Float64Array.of(174, 7, 170, 7) }];
    return result;
  };

  it('is drawn with the frame of the sheet, with its line', async () => {
    const { sheets } = await printOf(beside());
    const [{ pieces, frame } = { pieces: [], frame: { texts: [], strokes: [] } }] = sheets;
    expect(pieces[0]!.texts).toEqual([]);
    expect(pieces[0]!.guides).toEqual([]);
    const { x, y } = beside().pieces[0]!;
    const name = frame.texts.find(({ text }) => text === 'A')!;
    expect(name.at[0]).toBeCloseTo(x + 175, 9);
    const lines = frame.strokes.map(({ points }) => points);
    expect(lines).toContainEqual([
      [x + 174, y + 7],
      [x + 170, y + 7],
    ]);
  });

  it('keeps the legend off its place', async () => {
    const boxes = async (result: JobResult) => {
      const { texts } = (await printOf(result)).sheets[0]!.frame;
      const cut = texts.find(({ text }) => text === 'cut')!;
      return cut.at;
    };
    expect(await boxes(beside())).not.toEqual(await boxes(cubeResult()));
  });

  it('stays away where a machine cuts', async () => {
    const { sheets } = await printOf(beside(), { options: { machine: 'generic' } });
    expect(sheets[0]!.frame).toEqual({ strokes: [], texts: [] });
  });
});

describe('corrected sheets', () => {
  it('are longer where the printer is short, per axis and about the middle', async () => {
    const plain = await printOf(cubeResult());
    const corrected = await printOf(cubeResult(), { options: { measured: [49, 50.5] } });
    const at = (print: typeof plain) => print.sheets[0]!.pieces[0]!.cuts[0]![0]!;
    const [[x, y], [u, v]] = [at(plain), at(corrected)];
    expect(u).toBeCloseTo(105 + (x - 105) * (50 / 49), 9);
    expect(v).toBeCloseTo(148.5 + (y - 148.5) * (50 / 50.5), 9);
    expect(corrected.notices).toEqual([]);
    const texts = corrected.sheets[0]!.frame.texts.map(({ text }) => text);
    expect(texts).toContain('sheet 1 of 1 · print at 100 % · corrected for 49 × 50.5 mm');
  });

  it('tell when they leave the page', async () => {
    const { notices } = await printOf(cubeResult(), { margin: 0, options: { measured: [45, 45] } });
    expect(notices.map(({ code }) => code)).toContain('beyond-page');
  });

  it.each([
    [47, 50, 12],
    [50, 47, 15],
    [46, 48, 14],
    [50, 48.5, 10],
  ])(
    'keep rulers, title and crosses on paper with the margin that is told: %d × %d mm',
    async (...of) => {
      const [across, up, margin] = of;
      const print = (asked: number) =>
        printOf(cubeResult(), { margin: asked, options: { measured: [across, up], duplex: true } });
      const told = (await print(margin - 1)).notices.find(({ code }) => code === 'beyond-page');
      expect(told?.params).toMatchObject({ margin_mm: margin });
      const { backs, notices, sheets } = await print(margin);
      expect(notices.map(({ code }) => code)).not.toContain('beyond-page');
      for (const { width, height, frame } of [...sheets, ...backs]) {
        const points = [
          ...frame.strokes.flatMap((one) => one.points),
          ...frame.texts.map((t) => t.at),
        ];
        for (const [x, y] of points) {
          expect(Math.min(x, y, width - x, height - y)).toBeGreaterThanOrEqual(0);
        }
      }
    },
  );
});

describe('the legend', () => {
  const words = async (result: JobResult): Promise<string[]> =>
    (await printOf(result)).sheets[0]!.frame.texts.map(({ text }) => text);

  it('tells what occurs, and only that', async () => {
    expect(await words(cubeResult())).toEqual(expect.arrayContaining(['cut', 'mountain fold']));
    expect(await words(cubeResult())).not.toContain('valley fold');
    expect((await words(slitResult())).join()).not.toContain('flap');
    expect(await words(flapResult())).toEqual(
      expect.arrayContaining(['cut', 'valley fold', 'flap for glue']),
    );
  });

  it('can be left out', async () => {
    const { sheets } = await printOf(cubeResult(), { options: { legend: false } });
    expect(sheets[0]!.frame.texts.map(({ text }) => text)).not.toContain('cut');
  });

  it('goes into the margin where the sheet is full, and is missed where there is none', async () => {
    const full = cubeResult();
    const [piece] = full.pieces;
    // One square over all of the sheet.
    piece!.vertices = Float64Array.of(0, 0, 190, 0, 190, 277, 0, 277);
    piece!.outlines = [Int32Array.of(0, 1, 2, 3)];
    Object.assign(piece!, {
      edges: new Int32Array(),
      assignments: '',
      foldAngles: new Float64Array(),
    });
    const { sheets } = await printOf(full);
    const legend = sheets[0]!.frame.texts.find(({ text }) => text === 'cut')!;
    expect(legend.at[1]).toBeGreaterThan(287);
    const { notices } = await printOf(full, { margin: 5 });
    expect(notices.map(({ code }) => code)).toEqual(['no-legend']);
  });
});

describe('angles beside folds', () => {
  it('are told where there is room', async () => {
    const { sheets } = await printOf(cubeResult(), { options: { foldAngles: true } });
    const texts = sheets[0]!.pieces[0]!.texts.map(({ text }) => text);
    expect(texts.filter((text) => text === '90°')).toHaveLength(5);
    const { sheets: without } = await printOf(cubeResult());
    expect(without[0]!.pieces[0]!.texts.map(({ text }) => text)).not.toContain('90°');
  });
});
