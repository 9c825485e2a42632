import { describe, expect, it } from 'vitest';
import { makeReport, type Report } from '../../web/export/report.js';
import { defaultOptions } from '../../web/model/default-options.js';
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

  it('tells what came up when the sheets were drawn', () => {
    expect(reportOf(2).notices.map(({ code }) => code)).toEqual(['missing-glyphs']);
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
