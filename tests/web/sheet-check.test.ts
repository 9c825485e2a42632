import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { isBuilt, sharedFolder } from './command.js';
import { checkGuides } from './guide-check.js';
import { faultsOf, printedRun } from './printed-run.js';
import { checkSheets } from './sheet-check.js';
import { readSheet, type PieceLines, type Point, type SheetFile } from './sheet-file.js';

const shared = sharedFolder();

const cases = [
  ['organic/hand_574.obj', '--height', '150', '--flap-side', 'alternate'],
  ['organic/koala_574.obj', '--height', '150', '--paper', 'Letter', '--flap-side', 'both'],
  ['organic/penguin_1000.obj', '--height', '150', '--ids', 'flap', '--glue-strips', 'free'],
  ['organic/cat_300.obj', '--height', '300', '--margin', '5', '--ids', 'inside'],
  ['organic/cat_300.obj', '--height', '150', '--margin', '0', '--fold-angles', 'on'],
  ['academic/bunny-348.obj', '--sheets', '2', '--flaps', '7', '--flap-angle', '45'],
];

describe.skipIf(shared === null || !isBuilt)('written sheets', () => {
  it.each(cases)(
    'can be cut, folded and glued: %s %s %s %s %s',
    async (model, ...args) => {
      const path = join(shared!, 'models', model);
      expect(existsSync(path)).toBe(true);
      const run = await printedRun(path, ['--parts', '8', ...args]);
      const { flaps } = run.report;
      const at = args.indexOf('--margin');
      const margin = at < 0 ? 10 : Number(args[at + 1]);
      expect(faultsOf(run, margin)).toEqual([]);
      const drawn = run.svg.reduce((sum, sheet) => sum + sheet.strips.size, 0);
      expect(drawn).toBe(flaps.strips);
      expect(drawn > 0).toBe(args.includes('--glue-strips'));
      expect(flaps.full + flaps.shrunk).toBeGreaterThan(flaps.wanted / 2);
    },
    90_000,
  );

  it('are refused when mirrored, moved, or drawn over', async () => {
    const model = join(shared!, 'models/organic/cat_300.obj');
    const run = await printedRun(model, ['--parts', '8', '--sheets', '2']);
    const { sources, svg: sheets, pdf, fold, report } = run;
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
    expect(faults(nameless)).toMatch(/id [-A-Z]+:\d+ is on one side only/);
    const bare = changedBy((text) => text.replace(/(<\/text>\n)<path [^>]*>\n/g, '$1'));
    expect(faults(bare)).toMatch(/0 lines below \d+/);
    const shifted = changedBy((text) => text.replace(/(?<=<g id="cut"[^>]*>\n.*d="M)[\d.]+/, '3'));
    expect(faults(shifted)).toMatch(/in the margin/);

    const mirroredPage = ({ width, pieces, ...page }: SheetFile): SheetFile => {
      const turned = ([x, y]: Point): Point => [width - x, y];
      const mirror = (lines: PieceLines): PieceLines => ({
        ...lines,
        cuts: lines.cuts.map((walk) => walk.map(turned).reverse()),
        mountains: lines.mountains.map(([a, b]) => [turned(a), turned(b)]),
      });
      const mirrored = [...pieces].map(([letter, lines]) => [letter, mirror(lines)] as const);
      return { ...page, width, pieces: new Map(mirrored) };
    };
    expect(faults(pdf.map(mirroredPage))).toMatch(/is no fold|is not cut/);
  }, 90_000);

  it('are refused with guides that are out of scale, or in the way', async () => {
    const model = join(shared!, 'models/organic/cat_300.obj');
    const { pdf } = await printedRun(model, ['--parts', '2', '--measured', '49.6,50.2']);
    expect(checkGuides(pdf, 10, [50 / 49.6, 50 / 50.2])).toEqual([]);
    expect(checkGuides(pdf, 10).join('\n')).toMatch(/no ruler across[^]*no ruler up[^]*no box/);
    const moved = pdf.map((page) => ({
      ...page,
      guide: {
        ...page.guide,
        strokes: page.guide.strokes.map((walk) => walk.map(([x, y]): Point => [x, y + 100])),
      },
    }));
    expect(checkGuides(moved, 10).join('\n')).toMatch(/is on [A-Z]/);
  }, 90_000);
});
