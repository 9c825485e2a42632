import { describe, expect, it } from 'vitest';
import type { JobResult, Strip } from '../../web/model/job.js';
import { findingsOn, verdictOf } from '../../web/model/verdict.js';
import { addFlap, scaled } from './changed-result.js';
import { boxAndLidResult } from './fixtures.js';

const margin = 10;

/** The box and its lid on one sheet, and nothing wrong with them. */
function good(): JobResult {
  const result = boxAndLidResult();
  const pieces = result.pieces.map((piece) => ({ ...piece, sheet: 0 }));
  const ids = { printed: 8, skipped: [] };
  return { ...result, pieces, sheets: result.sheets.slice(0, 1), ids };
}

/** A strip of paper for a seam; it lies nowhere. */
function stripOf(id: string): Strip {
  const label = { text: id, x: 0, y: 0, angle: 0, size: 2 };
  const [outline, fold] = [new Float64Array(8), new Float64Array(4)];
  return { id, modelEdge: 0, sheet: 0, outline, fold, foldAngle: -90, label };
}

/** Codes and levels of the verdict on a result that was changed. */
function verdictOn(change: (result: JobResult) => void, result = good()): string[] {
  change(result);
  return verdictOf(result, margin).map(({ code, level, count }) => `${code} ${level} ${count}`);
}

describe('the verdict', () => {
  it('is green where nothing stands against a model', () => {
    expect(verdictOf(good(), margin)).toEqual([
      { code: 'buildable', level: 'green', count: 0, params: {} },
    ]);
  });

  it('is amber below seams of 12 mm in the middle and red below 4', () => {
    const none = (): void => undefined;
    expect(verdictOn(none, scaled(good(), 0.25))).toEqual(['hard amber 1', 'short-seams amber 8']);
    expect(verdictOn(none, scaled(good(), 0.101))[1]).toBe('short-seams amber 8');
    expect(verdictOn(none, scaled(good(), 0.099)).slice(0, 2)).toEqual([
      'not-buildable red 2',
      'short-seams red 8',
    ]);
  });

  it('goes by the share of the length without a flap', () => {
    const missing = (share: number) => (result: JobResult) => {
      const counts = { narrow: 1, thin: 0, blocked: 2, short: 0 };
      result.flaps = { ...result.flaps, missing: counts, wanted_mm: 320, missing_mm: 320 * share };
    };
    expect(verdictOn(missing(0.1))).toEqual(['buildable green 0']);
    expect(verdictOn(missing(0.11))).toEqual(['hard amber 1', 'missing-flaps amber 3']);
    expect(verdictOn(missing(0.51))).toEqual(['not-buildable red 1', 'missing-flaps red 3']);
  });

  it('takes a loose strip for a flap', () => {
    const withStrips = (count: number) => (result: JobResult) => {
      const missing = { narrow: 3, thin: 0, blocked: 0, short: 0 };
      result.flaps = { ...result.flaps, missing, wanted_mm: 320, missing_mm: 120, strips: count };
      result.strips = result.seams.slice(0, count).map(({ name }) => stripOf(name));
    };
    expect(verdictOn(withStrips(0))).toContain('missing-flaps amber 3');
    expect(verdictOn(withStrips(1))).toContain('missing-flaps amber 2');
    expect(verdictOn(withStrips(3))).toEqual(['buildable green 0']);
  });

  it('goes by the share of seams without a number', () => {
    const skip = (skipped: string[]) => (result: JobResult) => {
      result.ids = { printed: 18, skipped };
    };
    expect(verdictOn(skip(['A:1', 'A:2']))).toEqual(['buildable green 0']);
    expect(verdictOn(skip(['A:1', 'A:2', 'A:3']))[1]).toBe('missing-numbers amber 3');
  });

  it('names pieces, the worst first', () => {
    const spoil = (result: JobResult): void => {
      const [box, lid] = result.pieces as [JobResult['pieces'][0], JobResult['pieces'][0]];
      const { motion: _, ...unproved } = box;
      result.pieces = [
        { ...unproved, foldable: 'no', labels: [], necks: Float64Array.of(3) },
        { ...lid, overlaps: 2, width: 5, height: 5 },
      ];
    };
    expect(verdictOn(spoil)).toEqual([
      'not-buildable red 5',
      'overlapping-pieces red 1',
      'missing-names amber 1',
      'tiny-pieces amber 1',
      'weak-necks amber 1',
      'unproved-folding amber 1',
    ]);
    const result = good();
    spoil(result);
    expect(verdictOf(result, margin)[1]!.params).toEqual({ pieces: ['B'] });
  });

  it('is red for a piece that is not wholly on its sheet', () => {
    const push = (x: number) => (result: JobResult) => {
      result.pieces[1] = { ...result.pieces[1]!, x };
    };
    const { width } = good().pieces[1]!;
    expect(verdictOn(push(210 - margin - width))).toEqual(['buildable green 0']);
    expect(verdictOn(push(210 - margin - width + 0.1))[1]).toBe('beyond-paper red 1');
    expect(verdictOn(push(margin - 0.1))[1]).toBe('beyond-paper red 1');
  });

  it('is red for a run that was ended early', () => {
    expect(verdictOn((result) => result.pieces.pop())).toContain('unfinished red 2');
    const stopped = { ...good(), notices: [{ code: 'run-stopped', params: {} }] };
    expect(verdictOn(() => undefined, stopped)).toEqual(['hard amber 1', 'run-stopped amber 1']);
    expect(verdictOn((result) => result.pieces.pop(), stopped).join()).not.toContain('run-stopped');
  });

  it('tells of paper that could be saved, and counts it not', () => {
    const spare = { ...good(), sheets: boxAndLidResult().sheets };
    spare.pieces[1] = { ...spare.pieces[1]!, sheet: 1 };
    expect(verdictOn(() => undefined, spare)).toEqual(['buildable green 0', 'spare-sheet amber 1']);
    const params = { what: 'height', size_mm: 39, instead_mm: 40, sheets: 1, of: 2 };
    const smaller = { ...good(), notices: [{ code: 'smaller-saves-sheets', params }] };
    expect(verdictOn(() => undefined, smaller)[1]).toBe('spare-sheet amber 1');
  });

  it('tells what takes more than ten hours to build', () => {
    const seams = (result: JobResult, times: number): JobResult => ({
      ...result,
      seams: Array.from({ length: times }, () => result.seams).flat(),
    });
    // A minute for each of 8 seams, and a few more for the pieces.
    expect(verdictOn(() => undefined, seams(good(), 70))).toEqual(['buildable green 0']);
    expect(verdictOn(() => undefined, seams(good(), 80))).toEqual([
      'hard amber 1',
      'long-building amber 11',
    ]);
  });

  it('has a finding for all that it looks at', () => {
    const result = good();
    result.seams.forEach((_, seam) => addFlap(result, seam, 5));
    const findings = findingsOn(result, margin);
    expect(findings.every(({ level }) => level === 'green')).toBe(true);
    expect(new Set(findings.map(({ code }) => code)).size).toBe(13);
  });
});
