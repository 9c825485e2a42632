import { describe, expect, it } from 'vitest';
import { defaultSettings } from '../../web/api/written-options.js';
import { editsFault } from '../../web/model/document-edits.js';
import type { JobResult } from '../../web/model/job.js';
import type { Settings } from '../../web/model/options.js';
import { remediesFor, remedyEdits } from '../../web/model/remedies.js';
import { findingsOn, type FindingCode } from '../../web/model/verdict.js';
import { english } from '../../web/words/en/index.js';
import { scaled } from './changed-result.js';
import { boxAndLidResult, tetrahedronResult } from './fixtures.js';

function remediesIn(result: JobResult, code: FindingCode, more: Partial<Settings> = {}) {
  const settings = { ...defaultSettings(), ...more };
  const finding = findingsOn(result, settings.margin).find((one) => one.code === code)!;
  return remediesFor(finding, { result, settings });
}

function wordsFor(...of: Parameters<typeof remediesIn>): string[] {
  return remediesIn(...of).map(english.verdict.remedy);
}

/** The edits of the first remedy, which documents take. */
function editsFor(...of: Parameters<typeof remediesIn>): unknown {
  const edits = remedyEdits(remediesIn(...of)[0]!);
  expect(editsFault(edits)).toBeNull();
  return edits;
}

/** The lid is an own part, and something is wrong with it. */
function spoilt(change: Partial<JobResult['pieces'][0]>): JobResult {
  const result = boxAndLidResult();
  result.pieces[1] = { ...result.pieces[1]!, ...change };
  return result;
}

describe('what helps', () => {
  it('is nothing where nothing is wrong', () => {
    const result = boxAndLidResult();
    const green = findingsOn(result, 10).filter(({ level }) => level === 'green');
    const looked = { result, settings: defaultSettings() };
    expect(green.flatMap((finding) => remediesFor(finding, looked))).toEqual([]);
  });

  it('is a larger model or fewer triangles where seams are too short', () => {
    const small = scaled(tetrahedronResult(), 0.25);
    const model = { ...small.model, faces: new Int32Array(2400) };
    const result = { ...small, model };
    expect(wordsFor(result, 'short-seams')).toEqual(['Make it 20 mm high', 'Use 470 triangles']);
    expect(editsFor(result, 'short-seams')).toEqual([{ kind: 'paper', options: { height: 20 } }]);
    expect(remedyEdits(remediesIn(result, 'short-seams')[1]!)).toBeNull();
  });

  it('is strips of paper for seams without a flap, unless there are some', () => {
    const result = boxAndLidResult();
    const missing = { narrow: 8, thin: 0, blocked: 0, short: 0 };
    result.flaps = { ...result.flaps, missing, wanted_mm: 320, missing_mm: 320 };
    expect(editsFor(result, 'missing-flaps')).toEqual([
      { kind: 'paper', options: { glueStrips: 'all' } },
    ]);
    expect(remediesIn(result, 'missing-flaps', { 'glue-strips': 'all' })).toEqual([]);
  });

  it('is numbers on flaps, unless they are there', () => {
    const result = boxAndLidResult();
    expect(editsFor(result, 'missing-numbers', { ids: 'both' })).toEqual([
      { kind: 'paper', options: { ids: 'flap' } },
    ]);
    expect(remediesIn(result, 'missing-numbers')).toEqual([]);
  });

  it('is a search of the parts that are hard to build', () => {
    const again = [{ kind: 'again', part: 2, seed: 0x01234567 }];
    // Squares of 40 mm, 50 times as large, fit no sheet.
    const weak = spoilt({ necks: Float64Array.of(0.1) });
    expect(editsFor(weak, 'weak-necks')).toEqual(again);
    const larger = spoilt({ necks: Float64Array.of(4.5, 4) });
    expect(wordsFor(larger, 'weak-necks')).toEqual(['Make it 50 mm high', 'Search B again']);
    expect(editsFor(spoilt({ overlaps: 1 }), 'overlapping-pieces')).toEqual(again);
    const { motion: _, ...unproved } = boxAndLidResult().pieces[1]!;
    const result = boxAndLidResult();
    result.pieces[1] = { ...unproved, foldable: 'no' };
    expect(editsFor(result, 'unproved-folding')).toEqual(again);
    result.pieces[1] = { ...unproved, foldable: 'unchecked' };
    expect(remediesIn(result, 'unproved-folding')).toEqual([]);
  });

  it('is joining a tiny piece to the one beside it', () => {
    const tiny = spoilt({ width: 5, height: 5 });
    expect(wordsFor(tiny, 'tiny-pieces')).toEqual(['Join B to A']);
    expect(editsFor(tiny, 'tiny-pieces')).toEqual([{ kind: 'merge', parts: [2, 1] }]);
  });

  it('is the whole search for a run that was stopped', () => {
    const result = boxAndLidResult();
    result.notices = [{ code: 'run-stopped', params: {} }];
    expect(wordsFor(result, 'run-stopped')).toEqual(['Unfold again to the end']);
    expect(remedyEdits(remediesIn(result, 'run-stopped')[0]!)).toBeNull();
    result.pieces.pop();
    expect(remediesIn(result, 'unfinished')).toEqual([{ kind: 'finish' }]);
  });

  it('is a size at which a sheet less does', () => {
    const result = boxAndLidResult();
    expect(editsFor(result, 'spare-sheet')).toEqual([{ kind: 'paper', options: { sheets: 1 } }]);
    const params = { what: 'width', size_mm: 149, instead_mm: 150, sheets: 1, of: 2 };
    const notices = [{ code: 'smaller-saves-sheets', params }];
    expect(wordsFor({ ...result, notices }, 'spare-sheet')).toEqual([
      'Make it 149 mm wide: 1 sheet less',
    ]);
  });
});
