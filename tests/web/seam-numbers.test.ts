import { describe, expect, it } from 'vitest';
import { numberIn, numberRuns, seamNumbers } from '../../web/export/seam-numbers.js';
import { cutPairs } from '../../web/model/borders.js';
import type { IdPlace, JobResult } from '../../web/model/job.js';
import { engineResult } from './engine-result.js';
import { cubeResult } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { isEngineBuilt } from './thread-pool.js';

/** What the engine's rule says: seams count along the outlines, piece by piece. */
function counted({ pieces }: JobResult): Map<number, string> {
  const joined = new Set(
    cutPairs(pieces).map(([{ edge, piece }]) => pieces[piece]!.modelEdges[edge]!),
  );
  const numbers = new Map<number, string>();
  for (const { assignments, edges, modelEdges, outlines } of pieces) {
    const from = new Map<number, number>();
    modelEdges.forEach((edge, e) => {
      if (assignments[e] === 'B' && joined.has(edge)) from.set(edges[2 * e]!, edge);
    });
    for (const vertex of outlines.flatMap((walk) => [...walk])) {
      const edge = from.get(vertex);
      if (edge !== undefined && !numbers.has(edge)) numbers.set(edge, `${numbers.size + 1}`);
    }
  }
  return numbers;
}

describe.skipIf(!isEngineBuilt)('numbers found beside edges', () => {
  it.each(['inside', 'flap', 'both'] satisfies IdPlace[])(
    'are those of the seams: %s',
    async (ids) => {
      const result = await engineResult(objText(wavyRing(10)), { parts: 4, ids });
      const right = counted(result);
      const found = seamNumbers(result.pieces);
      expect(result.ids.printed).toBeGreaterThan(50);
      expect(found.size).toBe(result.ids.printed);
      for (const [edge, number] of found) expect(number).toBe(right.get(edge));
    },
  );

  it('are of no seam whose own number had no room', async () => {
    const small = { parts: 6, sizing: 'height', size: 40 } as const;
    const result = await engineResult(objText(wavyRing(12)), small);
    const right = counted(result);
    const found = seamNumbers(result.pieces);
    expect(result.ids.skipped.length).toBeGreaterThan(20);
    expect(found.size).toBe(result.ids.printed);
    for (const [edge, number] of found) expect(number).toBe(right.get(edge));
  });

  it('are none where none are printed', async () => {
    const result = await engineResult(objText(wavyRing(10)), { parts: 4, ids: 'none' });
    expect(seamNumbers(result.pieces).size).toBe(0);
  });
});

it('takes no name for a number', () => {
  expect(seamNumbers(cubeResult().pieces).size).toBe(0);
  expect(['12', 'C:12', 'C12', 'C'].map(numberIn)).toEqual(['12', '12', '12', null]);
});

describe('numberRuns', () => {
  it.each([
    [[], ''],
    [['4'], '4'],
    [['4', '5'], '4, 5'],
    [['12', '13', '14', '20', '9', '8', '7'], '12–14, 20, 9–7'],
    [['1', '2', '3', '2', '1'], '1–3, 2, 1'],
    [['5', '5'], '5, 5'],
  ])('keeps the order: %j', (numbers, text) => {
    expect(numberRuns(numbers).join(', ')).toBe(text);
  });
});
