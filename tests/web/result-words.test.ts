import { describe, expect, it } from 'vitest';
import {
  leadSentence,
  netRemarks,
  repairRemarks,
  resultFacts,
} from '../../web/app/result-words.js';
import type { JobResult } from '../../web/model/job.js';
import { paperSizes } from '../../web/model/paper.js';
import type { StageSeconds } from '../../web/model/stage-seconds.js';
import { boxAndLidResult } from './fixtures.js';

const paper = paperSizes.find(({ name }) => name === 'A4')!;
const seconds: StageSeconds = {
  read: 0,
  learn: 0,
  cluster: 0,
  search: 0,
  fold: 0,
  compact: 0,
  paper: 0,
  total: 0,
};

function sizeOf(result: JobResult): string {
  return resultFacts({ ...result, seconds }).find(([label]) => label === 'Finished size')![1];
}

describe('the words of a result', () => {
  it('have a line for every repair and every notice', () => {
    const told = Array.from({ length: 30 }, (_, i) => ({ code: 'c', count: 1, text: `line ${i}` }));
    const result = { ...boxAndLidResult(), repairs: told, notices: told };
    const lines = told.map(({ text }) => `L${text.slice(1)}.`);
    expect(repairRemarks(result)).toEqual(lines);
    expect(netRemarks(result)).toEqual(expect.arrayContaining(lines));
  });

  it('tell pieces and sheets, even of a run that was cancelled', () => {
    const result = boxAndLidResult();
    expect(leadSentence(result, paper)).toMatch(/ on \d+ sheets? of A4\.$/);
    const [first] = result.pieces;
    const words =
      '1 of 2 parts had their nets when the run was cancelled: 1 piece on 2 sheets of A4.';
    expect(leadSentence({ ...result, pieces: [first!] }, paper)).toBe(words);
  });

  it('tell small sizes to a tenth of a millimetre', () => {
    const result = boxAndLidResult();
    const vertices = Float64Array.of(0, 0, 0, 4.26, 12.4, 0.04);
    const model = { ...result.model, vertices };
    expect(sizeOf({ ...result, model })).toBe('4.3 × 12 × 0 mm');
  });
});
