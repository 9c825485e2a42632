import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import DxfParser from 'dxf-parser';
import { describe, expect, it } from 'vitest';
import { exportFormats } from '../../web/export/formats.js';
import { checkedRun } from './checked-run.js';
import { foldwright, isBuilt, readReport, withModel } from './command.js';
import { cube } from './fixtures.js';
import { checkFold } from './fold-check.js';
import { parseFold } from './fold-file.js';
import { objText, wavyRing } from './model-text.js';
import { readPdf } from './pdf-file.js';
import { schemaErrors } from './report-schema.js';
import { readSheet } from './sheet-file.js';

interface ToldReport {
  model: { repairs: { text: string }[] };
  notices: { code: string; text: string }[];
}

describe.skipIf(!isBuilt)('a run of the command line', () => {
  it('writes every output and a report of them', () =>
    withModel(objText(cube), async (folder, model) => {
      const names = exportFormats.map((format) => `out.${format}`);
      const paths = names.map((name) => join(folder, name));
      const report = join(folder, 'report.json');
      const outputs = paths.flatMap((path) => ['-o', path]);
      const args = [model, ...outputs, '--report', report, '--parts', '1', '--quiet'];
      expect(await foldwright(args)).toEqual({ status: 0, stdout: '', stderr: '' });
      const written = readReport(report);
      expect(schemaErrors(written)).toEqual([]);
      expect(written.files).toEqual([...paths, report]);
      expect(readdirSync(folder).sort()).toEqual([
        'model.obj',
        ...[...names].sort(),
        'report.json',
      ]);
      expect(written.options).toMatchObject({ parts: 1, solver: 'tree', paper: 'A4', seed: 1 });
      expect(written.segmentation).toEqual(Array.from({ length: 12 }, () => 1));
      expect(checkFold(parseFold(readFileSync(paths[0]!, 'utf8')))).toEqual([]);
    }));

  it('writes sheets for machines as files of their own, and says what that leaves out', () =>
    withModel(objText(wavyRing(12)), async (folder, model) => {
      const formats = ['svg', 'pdf', 'dxf', 'png'];
      const outputs = formats.flatMap((format) => ['-o', join(folder, `out.${format}`)]);
      const looks = [
        '--machine',
        'silhouette',
        '--style',
        'blender',
        '--dpi',
        '72',
        '--assembly',
        'on',
      ];
      const { status, stderr } = await foldwright([model, '--parts', '6', ...looks, ...outputs]);
      expect(status).toBe(0);
      expect(stderr).toContain("option '--style' changes nothing without '--machine none'");
      const sheets = Number(/on (\d+) sheets/.exec(stderr)![1]);
      const written = readdirSync(folder).filter((name) => name.startsWith('out'));
      const building = written.filter((name) => name.includes('building'));
      expect(written).toHaveLength(formats.length * sheets + building.length);
      const dxf = new DxfParser().parseSync(readFileSync(join(folder, 'out-1.dxf'), 'utf8'))!;
      const svg = readSheet(readFileSync(join(folder, 'out-1.svg'), 'utf8'));
      const pieces = [...svg.pieces.values()];
      const count = (layer: string): number =>
        dxf.entities.filter((entity) => entity.layer === layer).length;
      expect(count('CUT')).toBe(pieces.flatMap(({ cuts }) => cuts).length);
      expect(count('MOUNTAIN')).toBe(pieces.flatMap(({ mountains }) => mountains).length);
      expect(count('REGISTRATION')).toBe(3);

      // Pages for people are files of their own, too, in lines that no machine takes for cuts.
      const { pages } = await readPdf(
        new Uint8Array(readFileSync(join(folder, 'out-building.pdf'))),
      );
      const numbered = ['svg', 'png'].flatMap((format) =>
        pages.map((_, page) => `out-building-${page + 1}.${format}`),
      );
      expect(building.sort()).toEqual(['out-building.pdf', ...numbered].sort());
      const cover = readFileSync(join(folder, 'out-building-1.svg'), 'utf8');
      expect(cover).toContain('>How to build it</text>');
      expect(cover).not.toContain('#ff0000');
      expect(pages[0]!.paths.map(({ colour }) => colour)).not.toContain('#ff0000');
      expect([...pages[0]!.layers]).toEqual(['Guide']);
    }));

  it('numbers the sheets of one-page formats', () =>
    withModel(objText(wavyRing(12)), async (folder, model) => {
      const [output, report] = [join(folder, 'out.svg'), join(folder, 'report.json')];
      const args = [model, '-o', output, '--report', report, '--parts', '6', '--quiet'];
      expect((await foldwright(args)).status).toBe(0);
      const { sheets, files } = readReport(report);
      expect(sheets).toBeGreaterThan(1);
      const names = Array.from({ length: sheets }, (_, i) => join(folder, `out-${i + 1}.svg`));
      expect(files).toEqual([...names, report]);
      const expected = [
        'model.obj',
        'report.json',
        ...names.map((name) => name.split('/').at(-1)!),
      ];
      expect(readdirSync(folder).sort()).toEqual(expected.sort());
    }));

  it('ends with a summary on stderr, whether or not anything is written', () =>
    withModel(objText(cube), async (folder, model) => {
      const summary = `${model}: 12 faces, 1 part, 1 piece on 1 sheet, 30 x 30 x 30 mm`;
      const args = [model, '--parts', '1', '--height', '30'];
      for (const outputs of [[], ['-o', join(folder, 'out.fold')]]) {
        const { status, stdout, stderr } = await foldwright([...args, ...outputs]);
        expect([status, stdout]).toEqual([0, '']);
        const lines = stderr.trimEnd().split('\n');
        expect(lines.at(-1)).toBe(summary);
        expect(lines).toContain('placing on sheets');
      }
      expect(readdirSync(folder).sort()).toEqual(['model.obj', 'out.fold']);
    }));

  it('tells which of its options change nothing', () =>
    withModel(objText(cube), async (folder, model) => {
      const { stderr } = await foldwright([
        model,
        '--unit',
        'cm',
        '--flaps',
        'none',
        '--flap-side',
        'both',
        '--assembly',
        'on',
        '--duplex',
        'on',
        '-o',
        join(folder, 'out.dxf'),
      ]);
      const notes = stderr.split('\n').filter((line) => line.startsWith("note: option '"));
      expect(notes).toEqual([
        "note: option '--unit' changes nothing without '--scale'",
        "note: option '--flap-side' changes nothing without flaps",
        "note: option '--duplex' changes nothing without a PDF file",
        "note: option '--assembly' changes nothing without a PDF, SVG or PNG file",
      ]);
    }));

  it('says nothing with --quiet', () =>
    withModel(objText(cube), async (_, model) => {
      expect(await foldwright([model, '--quiet'])).toEqual({ status: 0, stdout: '', stderr: '' });
    }));

  it('tells every repair and notice once, each on a line of its own', () => {
    // One face twice and one turned, so small that no number has room.
    const { vertices, faces } = cube;
    const [first, ...rest] = faces;
    const faulty = { vertices, faces: [[...first!].reverse(), ...rest, rest[0]!] };
    return withModel(objText(faulty), async (folder, model) => {
      const report = join(folder, 'report.json');
      const args = [model, '--parts', '1', '--height', '3', '--folding', 'off', '--report', report];
      const { status, stderr } = await foldwright(args);
      expect(status).toBe(0);
      const notes = stderr.split('\n').flatMap((line) => /^note: (.*)$/.exec(line)?.[1] ?? []);
      const told = JSON.parse(readFileSync(report, 'utf8')) as ToldReport;
      expect(told.model.repairs.length).toBeGreaterThan(0);
      for (const { text } of [...told.model.repairs, ...told.notices])
        expect(notes).toContain(text);
      expect(told.notices.map(({ code }) => code)).toContain('unchecked-pieces');
      expect(new Set(notes).size).toBe(notes.length);
      expect(notes.join('\n')).toMatch(
        /no room for a readable number at both sides of \d+ seams: /,
      );
    });
  });

  it('gives the same bytes for the same seed', () =>
    withModel(objText(wavyRing(12)), async (folder, model) => {
      const texts: string[] = [];
      for (const name of ['a.fold', 'b.fold']) {
        const args = [model, '-o', join(folder, name), '--parts', '3', '--seed', '7', '--quiet'];
        expect((await foldwright(args)).status).toBe(0);
        texts.push(readFileSync(join(folder, name), 'utf8'));
      }
      expect(texts[0]).toBe(texts[1]);
    }));

  it('adds a cover, a list of pieces and steps when they are asked for', () =>
    withModel(objText(wavyRing(8)), async (folder, model) => {
      const [pdf, svg, plain] = ['a.pdf', 'a.svg', 'b.pdf'].map((name) => join(folder, name));
      const args = [model, '--parts', '3', '--quiet', '--compact', 'off'];
      const path = join(folder, 'report.json');
      const all = ['--assembly', 'on', '-o', pdf!, '-o', svg!, '--report', path];
      expect((await foldwright([...args, ...all])).status).toBe(0);
      expect((await foldwright([...args, '-o', plain!])).status).toBe(0);
      const report = readReport(path);
      expect(schemaErrors(report)).toEqual([]);
      expect(report.options).toMatchObject({ assembly: 'on' });
      const pages = async (file: string) =>
        (await readPdf(new Uint8Array(readFileSync(file)))).pages.length;
      const building = readdirSync(folder).filter((name) => name.startsWith('a-building-'));
      expect(building.length).toBeGreaterThanOrEqual(3);
      expect(await pages(plain!)).toBe(report.sheets);
      expect(await pages(pdf!)).toBe(report.sheets + building.length);
      expect(report.files).toContain(join(folder, building[0]!));
    }));

  it.each([
    ['--heuristic', 'flat'],
    ['--heuristic', 'hybrid'],
    ['--heuristic', 'random'],
    ['--segment', 'spectral'],
    ['--proxy', '100'],
    ['--faces', '150'],
    ['--paper', '100x80', '--compact', 'on'],
    ['--orientation', 'landscape'],
    ['--margin', '0'],
  ])('makes nets that fold with %s %s', (...option: string[]) =>
    withModel(objText(wavyRing(12)), async (_, model) => {
      const args = ['--parts', '3', '--runs', '50', '--compact', 'off', ...option];
      const { ended, violations } = await checkedRun(model, args);
      expect(ended).toEqual({ status: 0, stdout: '', stderr: '' });
      expect(violations).toEqual([]);
    }),
  );

  it.each([
    [
      ['--up', 'y', '--height', '20'],
      [30, 20, 50],
    ],
    [
      ['--up', 'x', '--height', '60'],
      [40, 60, 100],
    ],
    [
      ['--up', 'z', '--width', '30'],
      [30, 50, 20],
    ],
    [
      ['--up', 'z', '--depth', '20'],
      [30, 50, 20],
    ],
    [
      ['--height', '20'],
      [30, 20, 50],
    ],
  ])('makes a box of 60 x 40 x 100 as large as %j say', (options, size) => {
    const [x, y, z] = [60, 40, 100];
    const box = {
      ...cube,
      vertices: cube.vertices.map(([a, b, c]) => [(a! * x) / 40, (b! * y) / 40, (c! * z) / 40]),
    };
    return withModel(objText(box), async (folder, model) => {
      const report = join(folder, 'report.json');
      const args = [model, '--parts', '1', '--report', report, '--quiet', ...options];
      expect((await foldwright(args)).status).toBe(0);
      const { size_mm } = JSON.parse(readFileSync(report, 'utf8')) as { size_mm: number[] };
      size_mm.forEach((mm, axis) => expect(mm).toBeCloseTo(size[axis]!, 9));
    });
  });

  it.each([
    [
      ['--paper', 'A5'],
      ['148mm', '210mm'],
    ],
    [
      ['--paper', '300x200', '--orientation', 'portrait'],
      ['200mm', '300mm'],
    ],
    [
      ['--paper', 'letter', '--orientation', 'landscape'],
      ['279.4mm', '215.9mm'],
    ],
  ])('draws on the paper of %j', (options, [width, height]) =>
    withModel(objText(cube), async (folder, model) => {
      const output = join(folder, 'out.svg');
      const args = [model, '-o', output, '--parts', '1', '--quiet', ...options];
      expect((await foldwright(args)).status).toBe(0);
      const svg = readFileSync(output, 'utf8');
      const sizes = [`width="${width}" height="${height}"`, `width="${height}" height="${width}"`];
      // Without an orientation the engine chooses.
      const allowed = options.includes('--orientation') ? sizes.slice(0, 1) : sizes;
      expect(allowed.some((size) => svg.includes(size))).toBe(true);
    }),
  );

  it('ends at once on SIGINT and leaves nothing behind', () =>
    withModel(objText(wavyRing(40)), async (folder, model) => {
      const args = [model, '-o', join(folder, 'out.fold'), '--proxy', '0', '--runs', '60000'];
      const { status, stdout } = await foldwright(args, { interrupt: 'SIGINT', limit: 20_000 });
      expect([status, stdout]).toEqual([4, '']);
      expect(readdirSync(folder)).toEqual(['model.obj']);
    }));

  it('says in one line what is wrong with a model', () =>
    withModel('v 0 0 0\nf 1 2 3\n', async (folder, model) => {
      const { status, stdout, stderr } = await foldwright([model, '--quiet']);
      expect([status, stdout]).toEqual([3, '']);
      expect(stderr.startsWith(`${model}: `)).toBe(true);
      expect(stderr.trimEnd().split('\n')).toHaveLength(1);
      expect(readdirSync(folder)).toEqual(['model.obj']);
    }));
});
