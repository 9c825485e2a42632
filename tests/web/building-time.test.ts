import { expect, it } from 'vitest';
import { assemblySteps } from '../../web/model/assembly-steps.js';
import { buildingTime, difficultyOf } from '../../web/model/building-time.js';
import type { JobResult } from '../../web/model/job.js';
import { boxAndLidResult, cubeResult } from './fixtures.js';

const timeOf = (result: JobResult) => buildingTime(result, assemblySteps(result.pieces));

it('is what the formula says', () => {
  // A piece, 14 sides of 40 mm to cut, 5 folds, 7 seams.
  const { glued, taped } = timeOf(cubeResult());
  expect(glued).toBeCloseTo(180 + 56 + 30 + 420, 6);
  expect(taped).toBeCloseTo(180 + 56 + 30 + 70, 6);
});

it('counts every piece and the seams between pieces', () => {
  // 12 + 4 sides to cut, 4 folds, 4 seams of the box and 4 of the lid.
  const { glued, taped } = timeOf(boxAndLidResult());
  expect(glued).toBeCloseTo(2 * 180 + 64 + 24 + 8 * 60, 6);
  expect(taped).toBeCloseTo(2 * 180 + 64 + 24 + 8 * 10, 6);
});

it('makes a model easy for an afternoon, medium for a weekend, and hard beyond', () => {
  expect([0, 2, 2.01, 6, 6.01, 36].map((hours) => difficultyOf(3600 * hours))).toEqual([
    'easy',
    'easy',
    'medium',
    'medium',
    'hard',
    'hard',
  ]);
});
