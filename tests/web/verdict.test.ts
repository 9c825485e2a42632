import { describe, expect, it } from 'vitest';
import type { JobResult } from '../../web/model/job.js';
import { verdictOf } from '../../web/model/verdict.js';
import { scaled } from './changed-result.js';
import { boxAndLidResult } from './fixtures.js';

function good(): JobResult {
  return { ...boxAndLidResult(), ids: { printed: 8, skipped: [] } };
}

/** Codes and levels of the verdict on a result that was changed. */
function verdictOn(change: (result: JobResult) => void, result = good()): string[] {
  change(result);
  return verdictOf(result).map(({ code, level, count }) => `${code} ${level} ${count}`);
}

describe('the verdict', () => {
  it('is green where nothing stands against a model', () => {
    expect(verdictOf(good())).toEqual([
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
        { ...unproved, foldable: 'no', labels: [] },
        { ...lid, overlaps: 2, width: 5, height: 5 },
      ];
    };
    expect(verdictOn(spoil)).toEqual([
      'not-buildable red 4',
      'overlapping-pieces red 1',
      'missing-names amber 1',
      'tiny-pieces amber 1',
      'unproved-folding amber 1',
    ]);
    const result = good();
    spoil(result);
    expect(verdictOf(result)[1]!.params).toEqual({ pieces: ['B'] });
  });

  it('is red for a run that was ended early', () => {
    expect(verdictOn((result) => result.pieces.pop())).toContain('unfinished red 2');
  });
});
