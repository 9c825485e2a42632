import { describe, expect, it } from 'vitest';
import { makeReport, type Report } from '../../web/export/report.js';
import { reportText } from '../../web/export/report-text.js';
import { defaultOptions } from '../../web/model/default-options.js';
import { english } from '../../web/words/en/index.js';
import { addFlap } from './changed-result.js';
import { boxAndLidResult } from './fixtures.js';
import { schemaErrors } from './report-schema.js';

function reportOf(parts: number, result = boxAndLidResult()): Report {
  return makeReport({
    version: '0.1.0',
    options: { parts: parts || 'auto', seed: 1 },
    job: { ...defaultOptions, parts },
    files: ['out-1.svg', 'out-2.svg', 'report.json'],
    result,
    printed: [{ code: 'missing-glyphs', params: { letters: ['X'] } }],
    seconds: {
      read: 0.1,
      learn: 1,
      cluster: 0.2,
      search: 0.3,
      fold: 0,
      compact: 0,
      paper: 0.1,
      total: 1.7,
    },
    words: english,
  });
}

describe('makeReport', () => {
  it('is valid', () => {
    expect(schemaErrors(reportOf(0))).toEqual([]);
  });

  it('tells what was asked for and what came out', () => {
    expect(reportOf(0).parts_requested).toBe('auto');
    const report = reportOf(2);
    expect(report.parts_requested).toBe(2);
    expect(report.parts).toBe(2);
    expect(report.size_mm).toEqual([40, 40, 40]);
    expect(report.pieces.map(({ faces }) => faces)).toEqual([10, 2]);
    expect(report.sheets).toBe(2);
    expect(report.result_hash).toBe('0123456789abcdef');
  });

  it('counts parts, pieces and sheets from 1', () => {
    const report = reportOf(2);
    expect(report.pieces.map(({ id, part, sheet }) => [id, part, sheet])).toEqual([
      [1, 1, 1],
      [2, 2, 2],
    ]);
    expect(new Set(report.segmentation)).toEqual(new Set([1, 2]));
    expect(schemaErrors({ ...report, pieces: [{ ...report.pieces[0]!, part: 0 }] })).toHaveLength(
      1,
    );
  });

  it('keeps dropped faces apart from parts', () => {
    const result = boxAndLidResult();
    result.segmentation[3] = -1;
    const { segmentation } = reportOf(2, result);
    expect(segmentation[3]).toBe(-1);
    expect(segmentation.filter((part) => part < 1)).toEqual([-1]);
  });

  it('tells what came up when the sheets were drawn, what is left out, and what to think of', () => {
    const { notices } = reportOf(2);
    const codes = ['missing-glyphs', 'missing-numbers', 'empty-sheet'];
    expect(notices.map(({ code }) => code)).toEqual(codes);
    expect(notices[2]).toEqual({
      code: 'empty-sheet',
      params: { sheet: 2, percent: 3, pieces: ['B'] },
      text: 'the last sheet, number 2, is almost empty: 3 % of it is used, by piece B',
    });
  });

  it('tells what there is to glue, once for all and for each piece', () => {
    const report = reportOf(2);
    expect([report.glue_mm, report.seams]).toEqual([320, 8]);
    expect([report.seams_within, report.seams_between]).toEqual([4, 4]);
    const glue = report.pieces.map((piece) => [piece.glue_within_mm, piece.glue_between_mm]);
    expect(glue).toEqual([
      [160, 160],
      [0, 160],
    ]);
  });

  it('tells how low flaps are, and how much paper is used within the margins', () => {
    const result = boxAndLidResult();
    expect(reportOf(2, result).flaps.shrunk_mm).toBeNull();
    expect(reportOf(2, result).efficiency).toBeCloseTo(4800 / (190 * 277), 12);
    [5, 2, 3.5].forEach((height, seam) => addFlap(result, seam, height));
    result.flaps = { ...result.flaps, wanted: 8, full: 1, shrunk: 2 };
    expect(reportOf(2, result).flaps.shrunk_mm).toEqual({ least: 2, median: 2.75 });
    expect(schemaErrors(reportOf(2, result))).toEqual([]);
  });

  it('comes to a verdict', () => {
    const [conclusion, reason, ...others] = reportOf(2).verdict;
    expect(conclusion).toEqual({ code: 'hard', level: 'amber', count: 1, params: {} });
    expect(reason).toEqual({
      code: 'missing-numbers',
      level: 'amber',
      count: 1,
      params: { share: 1 },
    });
    // Each piece has a sheet of its own.
    expect(others.map(({ code, level }) => [code, level])).toEqual([['spare-sheet', 'amber']]);
    expect(schemaErrors(reportOf(2))).toEqual([]);
  });

  it('has the parts of all faces on one line', () => {
    const report = reportOf(2);
    const text = reportText(report);
    expect(JSON.parse(text)).toEqual(report);
    expect(text).toContain('\n  "segmentation": [1,1,2,2,1,1,1,1,1,1,1,1],\n');
    expect(text).toContain('\n  "files": [\n    "out-1.svg",\n');
    expect(text).toContain('\n      "necks_mm": [],\n');
  });

  it('claims nothing that was not looked for', () => {
    for (const piece of reportOf(2).pieces) {
      expect(piece).toMatchObject({ foldable: 'line', certified: true });
    }
  });

  it('is refused by the schema when a field is missing or unknown', () => {
    const { seed: _, ...missing } = reportOf(2);
    expect(schemaErrors(missing)).toHaveLength(1);
    expect(schemaErrors({ ...reportOf(2), extra: 1 })).toHaveLength(1);
  });
});
