import { describe, expect, it } from 'vitest';
import { assemblySteps } from '../../web/model/assembly-steps.js';
import { borderOrder } from '../../web/model/border-order.js';
import type { JobResult } from '../../web/model/job.js';
import { engineResult } from './engine-result.js';
import { boxAndLidResult } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { isEngineBuilt } from './thread-pool.js';

/** Corners of the model at the ends of a piece's edge. */
function endsOf({ model, pieces }: JobResult, piece: number, edge: number): number[] {
  const { edges, faces, sources } = pieces[piece]!;
  return [edges[2 * edge]!, edges[2 * edge + 1]!].map((vertex) => {
    const at = faces.indexOf(vertex);
    return model.faces[3 * sources[Math.floor(at / 3)]! + (at % 3)]!;
  });
}

describe('borderOrder', () => {
  it('goes around a lid, each edge beside the one before', () => {
    const result = boxAndLidResult();
    const step = assemblySteps(result.pieces)[1]!;
    const order = borderOrder(result, step);
    expect(order).toHaveLength(4);
    const ends = order.map(([{ edge, piece }]) => endsOf(result, piece, edge));
    for (let i = 0; i < 4; ++i) {
      expect(ends[i]!.filter((end) => ends[(i + 1) % 4]!.includes(end))).toHaveLength(1);
    }
  });

  it('is empty for the first piece', () => {
    const result = boxAndLidResult();
    expect(borderOrder(result, assemblySteps(result.pieces)[0]!)).toEqual([]);
  });

  it.skipIf(!isEngineBuilt)('has every border once, and breaks off only at forks', async () => {
    const result = await engineResult(objText(wavyRing(10)), { parts: 5 });
    for (const step of assemblySteps(result.pieces)) {
      const order = borderOrder(result, step);
      expect(new Set(order)).toEqual(new Set(step.borders));
      expect(order).toHaveLength(step.borders.length);
      const ends = order.map((pair) => {
        const { edge } = pair.find(({ piece }) => piece === step.piece)!;
        return endsOf(result, step.piece, edge);
      });
      const counts = new Map<number, number>();
      for (const end of ends.flat()) counts.set(end, (counts.get(end) ?? 0) + 1);
      const open = [...counts.values()].filter((count) => count !== 2).length;
      const breaks = ends.filter(
        (one, i) => i > 0 && !one.some((end) => ends[i - 1]!.includes(end)),
      );
      expect(breaks.length).toBeLessThanOrEqual(Math.max(open, 1) * 2);
    }
  });
});
