import { describe, expect, it } from 'vitest';
import { numberIn, numberRuns, seamNumbers } from '../../web/export/seam-numbers.js';
import type { IdPlace } from '../../web/model/job-options.js';
import { engineResult } from './engine-result.js';
import { cubeResult } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { isEngineBuilt } from './thread-pool.js';

describe.skipIf(!isEngineBuilt)('numbers of seams', () => {
  it.each(['inside', 'flap', 'both'] satisfies IdPlace[])(
    'are printed on both pieces: %s',
    async (ids) => {
      const result = await engineResult(objText(wavyRing(10)), { parts: 4, ids });
      const found = seamNumbers(result);
      expect(result.ids.printed).toBeGreaterThan(50);
      const printed = result.seams.filter(({ name }) => !result.ids.skipped.includes(name));
      expect(printed).toHaveLength(result.ids.printed);
      for (const { modelEdges, pieces, texts } of printed) {
        expect(found.get(modelEdges[0]!)).toBe(numberIn(texts[0]));
        pieces.forEach((piece, side) => {
          const labels = result.pieces[piece]!.labels.map(({ text }) => text);
          expect(labels).toContain(texts[side]);
        });
      }
    },
  );

  it('are of no seam whose own number had no room', async () => {
    const small = { parts: 6, sizing: 'height', size: 40 } as const;
    const result = await engineResult(objText(wavyRing(12)), small);
    const found = seamNumbers(result);
    expect(result.ids.skipped).not.toHaveLength(0);
    for (const { modelEdges, name } of result.seams) {
      expect(found.has(modelEdges[0]!)).toBe(!result.ids.skipped.includes(name));
    }
  });

  it('are none where none are printed', async () => {
    const result = await engineResult(objText(wavyRing(10)), { parts: 4, ids: 'none' });
    expect(seamNumbers(result).size).toBe(0);
  });
});

it('takes no name for a number', () => {
  expect(seamNumbers(cubeResult()).size).toBe(0);
  expect(['12', 'C:12', 'C12', 'C'].map(numberIn)).toEqual(['12', '12', '12', null]);
});

describe('numberRuns', () => {
  it.each([
    [[], ''],
    [['4'], '4'],
    [['4', '5'], '4, 5'],
    [['12', '13', '14', '20', '9', '8', '7'], '12–14, 20, 9–7'],
    [['1', '2', '3', '2', '1'], '1–3, 2, 1'],
    [['5', '5', '6', '6'], '5, 6'],
  ])('keeps the order: %j', (numbers, text) => {
    expect(numberRuns(numbers).join(', ')).toBe(text);
  });
});
