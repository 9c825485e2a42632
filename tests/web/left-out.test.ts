import { describe, expect, it } from 'vitest';
import { leftOut } from '../../web/model/left-out.js';
import type { JobResult } from '../../web/model/job.js';
import { boxAndLidResult } from './fixtures.js';

function resultWith(change: (result: JobResult) => void): JobResult {
  const result = boxAndLidResult();
  result.ids = { printed: 9, skipped: [] };
  change(result);
  return result;
}

describe('what has no room on paper', () => {
  it('is nothing where everything has', () => {
    expect(leftOut(resultWith(() => undefined))).toEqual([]);
  });

  it('is named seam by seam', () => {
    const result = resultWith((of) => (of.ids.skipped = ['A:3', 'A-B:1', 'A-B:2', 'A:12']));
    expect(leftOut(result)).toEqual([
      'no room for a readable number at both sides of 4 seams: A: 3, 12; A-B: 1, 2',
    ]);
  });

  it('is counted by its cause for flaps', () => {
    const result = resultWith((of) => {
      const missing = { narrow: 0, thin: 2, blocked: 0, short: 1 };
      of.flaps = { ...of.flaps, wanted: 12, wanted_mm: 200, missing_mm: 50, missing };
    });
    expect(leftOut(result)).toEqual([
      expect.stringMatching(
        /^no flap on 3 seams: 2 where .* thin .*, 1 too short for one\. That is 25 %/,
      ),
    ]);
  });

  it('is told for the names of pieces', () => {
    const result = resultWith((of) => of.pieces.forEach((piece) => (piece.labels = [])));
    expect(leftOut(result)).toEqual([
      'no room for their names on pieces A, B; short names need less',
    ]);
  });
});
