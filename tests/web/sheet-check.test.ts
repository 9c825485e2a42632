import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { foldwright, inFolder, isBuilt, sharedFolder } from './command.js';
import { parseFold, type FoldFile } from './fold-file.js';
import { checkSheets, type IdsReport } from './sheet-check.js';
import { readSheet, type SheetFile } from './sheet-file.js';

const shared = sharedFolder();

interface Written {
  sheets: SheetFile[];
  sources: string[];
  fold: FoldFile;
  report: {
    ids: IdsReport;
    flaps: { wanted: number; full: number; shrunk: number; strips: number; taped: number };
  };
}

/** Runs one model and reads back what it wrote. */
function write(model: string, args: string[]): Promise<Written> {
  return inFolder(async (folder) => {
    const path = (name: string): string => join(folder, name);
    const outputs = ['-o', path('out.svg'), '-o', path('out.fold'), '--report', path('r.json')];
    const ended = await foldwright([model, ...outputs, '--quiet', ...args]);
    expect([ended.status, ended.stderr]).toEqual([0, '']);
    const names = readdirSync(folder).filter((name) => name.endsWith('.svg'));
    const sources = names.map((name) => readFileSync(path(name), 'utf8'));
    return {
      sources,
      sheets: sources.map(readSheet),
      fold: parseFold(readFileSync(path('out.fold'), 'utf8')),
      report: JSON.parse(readFileSync(path('r.json'), 'utf8')) as Written['report'],
    };
  });
}

const cases = [
  ['organic/cat_300.obj', '--height', '150'],
  ['organic/hand_574.obj', '--height', '150', '--flap-side', 'alternate'],
  ['organic/koala_574.obj', '--height', '150', '--paper', 'Letter', '--flap-side', 'both'],
  ['organic/penguin_1000.obj', '--height', '150', '--ids', 'flap', '--glue-strips', 'free'],
  ['organic/cat_300.obj', '--height', '300', '--margin', '5', '--ids', 'inside'],
  ['academic/bunny-348.obj', '--sheets', '2', '--flaps', '7', '--flap-angle', '45'],
];

describe.skipIf(shared === null || !isBuilt)('written sheets', () => {
  it.each(cases)(
    'can be cut, folded and glued: %s %s %s %s %s %s %s',
    async (model, ...args) => {
      const path = join(shared!, 'models', model);
      expect(existsSync(path)).toBe(true);
      const { sheets, fold, report } = await write(path, ['--parts', '8', ...args]);
      const at = args.indexOf('--margin');
      const margin = at < 0 ? 10 : Number(args[at + 1]);
      expect(checkSheets(sheets, fold, report.ids, margin)).toEqual([]);
      const drawn = sheets.reduce((sum, sheet) => sum + sheet.strips.size, 0);
      expect(drawn).toBe(report.flaps.strips);
      expect(drawn > 0).toBe(args.includes('--glue-strips'));
      expect(report.flaps.full + report.flaps.shrunk).toBeGreaterThan(report.flaps.wanted / 2);
    },
    90_000,
  );

  it('are refused when mirrored, moved, or drawn over', async () => {
    const model = join(shared!, 'models/organic/cat_300.obj');
    const { sources, sheets, fold, report } = await write(model, ['--parts', '8', '--sheets', '2']);
    const faults = (changed: SheetFile[]): string =>
      checkSheets(changed, fold, report.ids, 10).join('\n');
    const changedBy = (change: (text: string) => string): SheetFile[] =>
      sources.map((source) => readSheet(change(source)));
    expect(faults(sheets)).toBe('');
    const mirror = (pair: string): string => {
      const [x, y] = pair.split(' ').map(Number);
      return `${sheets[0]!.width - x!} ${y}`;
    };
    const mirrored = changedBy((text) => text.replace(/(?<=[ML])[\d.]+ [\d.]+/g, mirror));
    expect(faults(mirrored)).toMatch(/is no fold|is not cut/);
    const swapped = changedBy((text) =>
      text
        .replace('fold-mountain', 'x')
        .replace('fold-valley', 'fold-mountain')
        .replace('"x"', '"fold-valley"'),
    );
    expect(faults(swapped)).toMatch(/is no fold/);
    const nameless = changedBy((text) => text.replace(/<text.*<\/text>\n/g, ''));
    expect(faults(nameless)).toMatch(/id \d+ is on one side only/);
    const shifted = changedBy((text) => text.replace(/(?<=<g id="cut">\n.*d="M)[\d.]+/, '3'));
    expect(faults(shifted)).toMatch(/in the margin/);
  }, 90_000);
});
