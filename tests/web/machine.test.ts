/** Sheets for cutting machines, in every format that they read. */
import { XMLParser } from 'fast-xml-parser';
import { describe, expect, it } from 'vitest';
import { writeFiles } from '../../web/export/files.js';
import { cricutBorder } from '../../web/export/machine.js';
import { writePdf } from '../../web/export/pdf.js';
import { writeSvg } from '../../web/export/svg.js';
import type { JobResult } from '../../web/model/job.js';
import type { Machine, PrintOptions } from '../../web/model/print-options.js';
import { boxAndLidResult, cubeResult, flapResult } from './fixtures.js';
import { readPdf } from './pdf-file.js';
import { printOf } from './printed.js';
import { readSheet } from './sheet-file.js';

const machines = ['silhouette', 'cricut', 'generic'] as const satisfies Machine[];

interface Element {
  stroke?: string;
  fill?: string;
  d: string;
  'data-piece'?: string;
}

interface Group {
  id: string;
  'inkscape:label': string;
  path?: Element[];
  text?: unknown;
}

function groupsOf(svg: string): Group[] {
  const parser = new XMLParser({
    ignoreAttributes: false,
    attributeNamePrefix: '',
    isArray: (name) => ['g', 'path'].includes(name),
  });
  return (parser.parse(svg) as { svg: { g: Group[] } }).svg.g;
}

async function svgOf(result: JobResult, options: Partial<PrintOptions>): Promise<string> {
  return writeSvg(await printOf(result, { options }), 0);
}

async function noticesOf(result: JobResult, options: Partial<PrintOptions>): Promise<string[]> {
  return (await printOf(result, { options })).notices.map(({ code }) => code);
}

/** The piece of a result at another place, which its own coordinates count from. */
function placedAt(result: JobResult, x: number, y: number): JobResult {
  Object.assign(result.pieces[0]!, { x, y });
  return result;
}

describe('a sheet for a machine', () => {
  it.each(machines)('for %s has pure colours, solid lines, and no furniture', async (machine) => {
    const svg = await svgOf(flapResult(), { machine });
    const groups = groupsOf(svg);
    const marks = machine === 'silhouette' ? ['registration'] : [];
    expect(groups.map(({ id }) => id)).toEqual([...marks, 'fold-valley', 'id', 'cut']);
    expect(svg).not.toMatch(/dasharray|<text|transform|font/);
    const colours = {
      'fold-mountain': '#0000ff',
      'fold-valley': '#00ff00',
      id: '#ff00ff',
      cut: '#ff0000',
    };
    for (const { id, path } of groups.filter((group) => group.id in colours)) {
      for (const { stroke, fill } of path!) {
        expect([id, stroke, fill]).toEqual([id, colours[id as keyof typeof colours], 'none']);
      }
    }
  });

  it('has the lines of the sheet for scissors', async () => {
    const mine = readSheet(await svgOf(flapResult(), { machine: 'generic' })).pieces.get('A')!;
    const theirs = readSheet(await svgOf(flapResult(), {})).pieces.get('A')!;
    expect({ ...mine, texts: [] }).toEqual({ ...theirs, texts: [] });
  });

  it('says which layer the Inkscape driver leaves out', async () => {
    const [marks] = groupsOf(await svgOf(cubeResult(), { machine: 'silhouette' }));
    expect(marks!['inkscape:label']).toBe('Regmarks');
    expect(marks!.path!.map(({ d }) => d)).toEqual([
      'M10 10L10 15L15 15L15 10Z',
      'M180 10L200 10L200 30M30 287L10 287L10 267',
    ]);
  });

  it('draws texts as closed lines near where they are printed', async () => {
    const groups = groupsOf(await svgOf(cubeResult(), { machine: 'generic' }));
    const [letter] = groups.find(({ id }) => id === 'id')!.path!;
    const numbers = letter!.d.match(/-?[\d.]+/g)!.map(Number);
    const xs = numbers.filter((_, i) => i % 2 === 0);
    const ys = numbers.filter((_, i) => i % 2 === 1);
    const { x, y, labels } = cubeResult().pieces[0]!;
    const [label] = labels;
    // A capital of 6 mm: 4.3 mm high, about as wide.
    expect(Math.max(...ys) - Math.min(...ys)).toBeCloseTo(0.714 * 6, 1);
    expect(Math.max(...xs) - Math.min(...xs)).toBeLessThan(6);
    expect((Math.max(...xs) + Math.min(...xs)) / 2).toBeCloseTo(x + label!.x, 0);
    expect(297 - (Math.max(...ys) + Math.min(...ys)) / 2).toBeCloseTo(y + label!.y, 0);
    expect(letter!.d.match(/M/g)).toHaveLength(letter!.d.match(/Z/g)!.length);
  });

  it('is not corrected for a printer', async () => {
    const measured = [49, 51] as const;
    const corrected = await svgOf(cubeResult(), { machine: 'cricut', measured });
    expect(corrected).toBe(await svgOf(cubeResult(), { machine: 'cricut' }));
  });

  it('keeps colours and widths that were asked for', async () => {
    const lines = { cut: { colour: '#123456', width: 0.5 } };
    const svg = await svgOf(cubeResult(), { machine: 'generic', lines });
    expect(svg).toContain('stroke="#123456" stroke-width="0.5"');
    expect(svg).toContain('stroke="#0000ff"');
  });

  it.each(['svg', 'pdf', 'dxf', 'png'] as const)('is a %s file for each mat', async (format) => {
    const result = boxAndLidResult();
    const write = async () => {
      const print = await printOf(result, { options: { machine: 'silhouette', dpi: 72 } });
      return writeFiles(format, { result, print, name: `box.${format}` });
    };
    const files = await write();
    expect(files.map(({ name }) => name)).toEqual([`box-1.${format}`, `box-2.${format}`]);
    expect(files).toEqual(await write());
  });

  it('is a PDF without fonts that has the same layers', async () => {
    const print = await printOf(flapResult(), { options: { machine: 'silhouette' } });
    const bytes = await writePdf(print);
    const { layers, pages } = await readPdf(bytes);
    expect(layers).toEqual(['Regmarks', 'Valley folds', 'Numbers', 'Cuts']);
    expect(pages[0]!.texts).toEqual([]);
    expect(new TextDecoder('latin1').decode(bytes)).not.toContain('/Font ');
    const marks = pages[0]!.paths.slice(0, 3);
    expect(marks.map(({ paint }) => paint)).toEqual(['fill', 'stroke', 'stroke']);
    expect(marks[1]!.width).toBeCloseTo(0.3, 3);
    for (const [i, point] of [
      [180, 287],
      [200, 287],
      [200, 267],
    ].entries()) {
      point.forEach((length, axis) => expect(marks[1]!.points[i]![axis]).toBeCloseTo(length, 3));
    }
    for (const { dash } of pages[0]!.paths) expect(dash).toEqual([]);
  });
});

describe('notices for machines', () => {
  it('tell what lies on the marks of a Silhouette, and which margin helps', async () => {
    // 160 x 120 mm: in the lower left corner, and between the marks.
    const options = { machine: 'silhouette' } as const;
    const { notices } = await printOf(cubeResult(), { options });
    expect(notices).toEqual([{ code: 'marks-not-free', params: { pieces: ['A'], margin_mm: 30 } }]);
    expect(await noticesOf(placedAt(cubeResult(), 20, 100), options)).toEqual([]);
  });

  it('tell what is larger than Cricut prints and then cuts', async () => {
    // What Cricut tells for its Print Then Cut: 7.2 x 10.62 in on A4, 7.44 x 9.94 in on Letter.
    for (const [width, height, most, mostHigh] of [
      [210, 297, 7.2 * 25.4, 10.62 * 25.4],
      [215.9, 279.4, 7.44 * 25.4, 9.94 * 25.4],
    ] as const) {
      for (const [side, limit] of [
        [width, most],
        [height, mostHigh],
      ] as const) {
        expect(side - 2 * cricutBorder).toBeLessThanOrEqual(limit);
        expect(side - 2 * cricutBorder).toBeGreaterThan(limit - 0.6);
      }
    }
    const options = { machine: 'cricut' } as const;
    expect(await noticesOf(cubeResult(), options)).toEqual([]);
    const wide = cubeResult();
    wide.sheets = [{ width: 180, height: 297 }];
    const { notices } = await printOf(wide, { options });
    expect(notices.map(({ code, params }) => [code, params['sheets']])).toEqual([
      ['cricut-area', [1]],
    ]);
  });

  it.each(['none', 'generic'] as const)('say nothing for %s', async (machine) => {
    expect(await noticesOf(cubeResult(), { machine })).toEqual([]);
  });
});
