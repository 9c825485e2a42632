/** Small inputs after what people reported, each with what is right about it: shared/cases/README.md. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { foldwright, inFolder, isBuilt, sharedFolder } from './command.js';
import { checkFold } from './fold-check.js';
import { parseFold } from './fold-file.js';
import { readSheet } from './sheet-file.js';

interface CaseReport {
  model: { faces: number; components: number; repairs: { code: string; count: number }[] };
  parts: number;
  pieces: object[];
  sheets: number;
  size_mm: [number, number, number];
  flaps: { wanted: number; full: number; shrunk: number; missing: Record<string, number> };
  notices: { code: string }[];
}

interface CaseRun {
  report: CaseReport;
  stderr: string;
  /** Counts of the repairs, by code. */
  repairs: Record<string, number>;
}

const folder = join(sharedFolder() ?? '', 'cases');

/** Unfolds a case, and has the nets judged. */
async function unfold(name: string, ...args: string[]): Promise<CaseRun> {
  return inFolder(async (out) => {
    const [fold, path] = [join(out, 'out.fold'), join(out, 'report.json')];
    const all = [join(folder, name), '-o', fold, '--report', path, ...args];
    const { status, stderr } = await foldwright(all);
    expect(status, stderr).toBe(0);
    expect(checkFold(parseFold(readFileSync(fold, 'utf8')))).toEqual([]);
    const report = JSON.parse(readFileSync(path, 'utf8')) as CaseReport;
    const repairs = Object.fromEntries(
      report.model.repairs.map(({ code, count }) => [code, count]),
    );
    return { report, stderr, repairs };
  });
}

/** A box by its triangles, its pieces and its extents in ascending order, the longest one 1. */
function expectBox({ report }: CaseRun, shape: number[]): void {
  expect([report.model.faces, report.model.components, report.pieces.length]).toEqual([12, 1, 1]);
  const extents = [...report.size_mm].sort((a, b) => a - b);
  for (const [i, share] of shape.entries()) expect(extents[i]! / extents[2]!).toBeCloseTo(share, 4);
}

const box = [1 / 3, 2 / 3, 1];

describe.skipIf(sharedFolder() === null || !isBuilt)('a case that people reported', () => {
  const simple = ['L_block', 'prism_L_30', 'prism_T_10', 'letter_F', 'tube_16', 'voxel_figure'];
  it.each(simple)('%s comes in as many pieces as one part needs', async (name) => {
    const whole = await unfold(`${name}.obj`, '--parts', '1');
    const free = await unfold(`${name}.obj`);
    expect(free.report.pieces.length).toBeLessThanOrEqual(whole.report.pieces.length);
    expect(free.report.sheets).toBeLessThanOrEqual(whole.report.sheets);
    expect(free.report.parts).toBe(free.report.pieces.length);
  });

  it('dodec_d5 is one net of twelve pentagons', async () => {
    const { report, repairs } = await unfold('dodec_d5.obj');
    expect([report.model.faces, report.pieces.length]).toEqual([36, 1]);
    // Of thirty edges eleven fold: nineteen are glued, each once. Diagonals are neither.
    expect(report.flaps.wanted).toBe(19);
    expect(repairs['flattened-faces']).toBe(12);
  });

  it('two_crossing_kites are two flat kites', async () => {
    const { report } = await unfold('two_crossing_kites.obj');
    expect([report.model.faces, report.model.components, report.pieces.length]).toEqual([4, 2, 2]);
    expect(report.flaps.wanted).toBe(0);
  });

  it('tent_two_sided is one skin, told once', async () => {
    const { report, repairs, stderr } = await unfold('tent_two_sided.obj');
    expect([report.model.faces, report.pieces.length]).toEqual([4, 1]);
    expect(repairs['merged-two-sided']).toBe(2);
    expect(stderr.match(/second time from the other side/g)).toHaveLength(1);
  });

  it.each([
    ['tent_crack', 2],
    ['crack_0.0001', 4],
  ])('%s is closed, with a count and the width', async (name, edges) => {
    const { report, repairs, stderr } = await unfold(`${name}.obj`);
    expect(report.model.components).toBe(1);
    expect(repairs['closed-cracks']).toBe(edges);
    expect(stderr).toMatch(/across cracks, the widest \S+ of the model's units wide\n/);
  });

  it('boxes_crossing are told, with what it means', async () => {
    const { report, repairs, stderr } = await unfold('boxes_crossing.obj');
    expect([report.model.components, report.pieces.length]).toEqual([2, 2]);
    expect(repairs['crossing-bodies']).toBe(1);
    expect(stderr).toContain('their pieces would collide when assembled (--crossing unite');
  });

  it('boxes_crossing are one body when they are united', async () => {
    const { report, repairs } = await unfold('boxes_crossing.obj', '--crossing', 'unite');
    expect(report.model.components).toBe(1);
    expect([repairs['united-bodies'], repairs['crossing-bodies']]).toEqual([2, undefined]);
  });

  it.each(['utf16_box.obj', 'obj_utf16le.obj', 'off_ncoff.off', 'ply_tristrips.ply'])(
    '%s is a box of 30 x 20 x 10',
    async (name) => expectBox(await unfold(name), box),
  );

  it.each(['stl_end_solid.stl', 'stl_missing_facet_words.stl'])('%s is a box', async (name) =>
    expectBox(await unfold(name), box),
  );

  it('wrong_ext_obj.stl is read by its contents, told once', async () => {
    const run = await unfold('wrong_ext_obj.stl');
    expectBox(run, box);
    expect(run.stderr.match(/the file is named \.stl, but holds OBJ/g)).toHaveLength(1);
  });

  it('junk_nul is refused with its line', async () => {
    const { status, stderr } = await foldwright([join(folder, 'junk_nul.obj')]);
    expect(status).toBe(3);
    expect(stderr).toMatch(/junk_nul\.obj: line 3: a NUL byte/);
  });

  it('zup_60x40x100 is as high as asked for along its z', async () => {
    for (const up of [['--up', 'z'], []]) {
      const { report } = await unfold('zup_60x40x100.stl', '--height', '150', ...up);
      for (const [i, extent] of [90, 150, 60].entries()) {
        expect(report.size_mm[i]).toBeCloseTo(extent, 6);
      }
    }
    const flat = await unfold('zup_60x40x100.stl', '--depth', '80', '--up', 'y');
    expect(flat.report.size_mm[2]).toBeCloseTo(80, 6);
  });

  it('cube400mm is too large by its real edges, and told what would fit', async () => {
    const model = join(folder, 'cube400mm.obj');
    const { status, stderr } = await foldwright([model, '--scale', '1', '--unit', 'mm']);
    expect(status).toBe(3);
    expect(stderr).toContain('a flat face of 400 x 400 mm is larger than a sheet');
    const share = Number(/would fit at (\d+) % of the size/.exec(stderr)?.[1]);
    await unfold('cube400mm.obj', '--scale', String(share / 100), '--unit', 'mm');
  });

  it.each([
    ['cyl_64', 1],
    ['torus_20x10', 4],
  ])('%s has few pieces, and every seam is counted', async (name, most) => {
    const { report } = await unfold(`${name}.obj`);
    expect(report.pieces.length).toBeLessThanOrEqual(most);
    const { wanted, full, shrunk, missing } = report.flaps;
    const missed = Object.values(missing).reduce((sum, count) => sum + count, 0);
    expect(full + shrunk + missed).toBe(wanted);
  });

  it('plate_keyhole is not cut across its flat faces', async () => {
    const { report } = await unfold('plate_keyhole.obj');
    const whole = await unfold('plate_keyhole.obj', '--parts', '1');
    expect(report.pieces.length).toBeLessThanOrEqual(whole.report.pieces.length);
  });

  it('plate_keyhole keeps its rims whole however many parts are asked for', async () => {
    const whole = await unfold('plate_keyhole.obj', '--parts', '1');
    for (const parts of ['2', '5']) {
      const { report } = await unfold('plate_keyhole.obj', '--parts', parts);
      expect(report.pieces.length).toBeLessThanOrEqual(whole.report.pieces.length);
      expect(report.parts).toBe(report.pieces.length);
      expect(report.notices.map(({ code }) => code)).toContain('parts-raised');
    }
  });

  it('cube_with_fin says where the fin is glued', () =>
    inFolder(async (out) => {
      const [svg, path] = [join(out, 'out.svg'), join(out, 'report.json')];
      const args = [join(folder, 'cube_with_fin.obj'), '-o', svg, '--report', path];
      const { status, stderr } = await foldwright(args);
      expect(status).toBe(0);
      expect(stderr).toContain('1 edge is glued to faces that it does not continue');
      const {
        files,
        ids,
        pieces: made,
      } = JSON.parse(readFileSync(path, 'utf8')) as {
        files: string[];
        ids: { printed: number; skipped: string[] };
        pieces: unknown[];
      };
      expect(ids.skipped).toEqual([]);
      const drawn = files.filter((file) => file.endsWith('.svg'));
      const sheets = drawn.map((file) => readSheet(readFileSync(file, 'utf8')));
      const pieces = sheets.flatMap((sheet) => [...sheet.pieces]);
      expect(pieces).toHaveLength(made.length);
      const named = pieces.map(([letter, { texts }]) => [letter, texts.map(({ text }) => text)]);
      expect(named, 'the joint, the only seam of the two, is named on both').toEqual([
        ['A', expect.arrayContaining(['B1']) as string[]],
        ['B', expect.arrayContaining(['A1']) as string[]],
      ]);
    }));

  it('terrain_utm is an open relief in few pieces', async () => {
    const { report, repairs } = await unfold('terrain_utm.obj');
    expect(report.pieces.length).toBeLessThanOrEqual(2);
    expect(repairs['open-border']).toBe(44);
  });
});
