import { describe, expect, it } from 'vitest';
import {
  leadSentence,
  noticeRemarks,
  repairRemarks,
  resultFacts,
} from '../../web/app/result-words.js';
import type { JobResult } from '../../web/model/job.js';
import { paperSizes } from '../../web/model/paper.js';
import { resultNotices } from '../../web/model/result-notices.js';
import type { StageSeconds } from '../../web/model/stage-seconds.js';
import { english } from '../../web/words/en/index.js';
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

function factOf(result: JobResult, name: string): string {
  return resultFacts(english, { ...result, seconds }, 10).find(([label]) => label === name)![1];
}

describe('the words of a result', () => {
  it('have a line for every repair and every notice', () => {
    const parts = Array.from({ length: 30 }, (_, i) => i + 1);
    const repairs = parts.map((count) => ({ code: 'halved-edges', count, params: {} }));
    const notices = parts.map((part) => ({ code: 'meets-itself', params: { part } }));
    const result = { ...boxAndLidResult(), repairs, notices };
    const why = 'halved, since two edges connected the same vertices.';
    const mended = parts.map((n) => `${n} ${n === 1 ? 'edge was' : 'edges were'} ${why}`);
    expect(repairRemarks(english, result)).toEqual(mended);
    const known = noticeRemarks(english, resultNotices(result, 10, []));
    for (const part of parts) {
      expect(known.filter((line) => line.startsWith(`Part ${part} has faces`))).toHaveLength(1);
    }
  });

  it('tell pieces and sheets, even of a run that was stopped', () => {
    const result = boxAndLidResult();
    expect(leadSentence(english, result, paper)).toMatch(/ on \d+ sheets? of A4\.$/);
    const [first] = result.pieces;
    const words =
      'Only 1 of 2 parts is whole: 1 piece on 2 sheets of A4. ' +
      'The other part is missing, so the model will have holes. Unfold again to get them all.';
    expect(leadSentence(english, { ...result, pieces: [first!] }, paper)).toBe(words);
    expect(leadSentence(english, { ...result, pieces: [] }, paper)).toMatch(
      /^None of 2 parts is whole: .* The other 2 parts are missing/,
    );
  });

  it('tell what there is to glue and how much of the paper is used', () => {
    const result = boxAndLidResult();
    expect(factOf(result, 'To glue')).toBe('0.3 m on 8 seams');
    // Six squares of 40 mm on two sheets of A4 with margins of 10 mm.
    expect(factOf(result, 'Paper used')).toBe('9 %');
  });

  it('tell small sizes to a tenth of a millimetre', () => {
    const result = boxAndLidResult();
    const vertices = Float64Array.of(0, 0, 0, 4.26, 12.4, 0.04);
    const model = { ...result.model, vertices };
    expect(factOf({ ...result, model }, 'Finished size')).toBe('4.3 × 12 × 0 mm');
  });
});
