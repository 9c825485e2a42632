import { describe, expect, it } from 'vitest';
import { leftOut } from '../../web/model/left-out.js';
import type { JobResult } from '../../web/model/job.js';
import { englishPhrase } from '../../web/words/phrase.js';
import { addFlap } from './changed-result.js';
import { boxAndLidResult } from './fixtures.js';

function wordsOn(change: (result: JobResult) => void): string[] {
  const result = boxAndLidResult();
  result.ids = { printed: 9, skipped: [] };
  change(result);
  return leftOut(result).map(englishPhrase);
}

function missFlaps(of: JobResult, strips = 0): void {
  const missing = { narrow: 0, thin: 2, blocked: 0, short: 1 };
  of.flaps = { ...of.flaps, wanted: 12, wanted_mm: 200, missing_mm: 50, missing, strips };
}

describe('what has no room on paper', () => {
  it('is nothing where everything has', () => {
    expect(wordsOn(() => undefined)).toEqual([]);
  });

  it('is named seam by seam', () => {
    const skipped = ['A:3', 'A-B:1', 'A-B:2', 'A:12'];
    expect(wordsOn((of) => (of.ids.skipped = skipped))).toEqual([
      'no room for a readable number at both sides of 4 seams: A: 3, 12; A-B: 1, 2',
    ]);
  });

  it('is counted by pieces where it is too much to be named', () => {
    const seams = (pieces: string, count: number): string[] =>
      Array.from({ length: count }, (_, i) => `${pieces}:${i + 1}`);
    const few = [...seams('A', 4), ...seams('B-C', 31)];
    expect(wordsOn((of) => (of.ids.skipped = few))).toEqual([
      'no room for a readable number at both sides of 35 seams: 31 on B-C, 4 on A',
    ]);
    const many = [...'ABCDEFGHIJ'].flatMap((piece) => seams(piece, 5));
    expect(wordsOn((of) => (of.ids.skipped = many))[0]).toMatch(/, 5 on H and 10 elsewhere$/);
  });

  it('is counted by its cause for flaps, with the pieces', () => {
    const seam = 'seams of pieces A, B: 2 where the neighbouring face is too thin to hide one, ';
    const share = '1 too short for one. That is 25 % of the length of all seams; ';
    expect(wordsOn(missFlaps)).toEqual([
      `no flap on 3 ${seam}${share}close them with tape or strips of paper from inside`,
    ]);
    expect(wordsOn((of) => missFlaps(of, 2))).toEqual([
      `no flap on 3 ${seam}${share}2 have a loose strip instead, tape does for others`,
    ]);
  });

  it('names no piece whose seams have their flaps', () => {
    const words = wordsOn((of) => {
      missFlaps(of);
      of.seams.forEach(({ pieces }, seam) => pieces.includes(1) && addFlap(of, seam, 5));
    });
    expect(words[0]).toMatch(/^no flap on 3 seams of piece A: /);
  });

  it('is told for the names of pieces', () => {
    expect(wordsOn((of) => of.pieces.forEach((piece) => (piece.labels = [])))).toEqual([
      'no room for their names on pieces A, B; short names need less',
    ]);
  });
});
