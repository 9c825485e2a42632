import { describe, expect, it } from 'vitest';
import { glueOf, measureSeams, shrunkHeights } from '../../web/model/seam-measures.js';
import { addFlap, scaled } from './changed-result.js';
import { engineResult } from './engine-result.js';
import { boxAndLidResult, cubeResult } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { isEngineBuilt } from './thread-pool.js';

describe('what seams take', () => {
  it('is the length of one side', () => {
    const lengths = measureSeams(cubeResult()).map(({ length }) => length);
    expect(lengths).toHaveLength(7);
    for (const length of lengths) expect(length).toBeCloseTo(40, 9);
  });

  it('tells seams within a piece from those between two', () => {
    const glue = glueOf(measureSeams(boxAndLidResult()));
    expect(glue.between.seams).toBe(4);
    expect(glue.between.mm).toBeCloseTo(160, 9);
    expect(glue.within.seams).toBe(4);
    expect(glue.within.mm).toBeCloseTo(160, 9);
  });

  it('counts the edges of a run in one', () => {
    const result = cubeResult();
    const [first, second, ...others] = result.seams;
    const modelEdges = Int32Array.of(...first!.modelEdges, ...second!.modelEdges);
    result.seams = [{ ...first!, modelEdges }, ...others];
    expect(measureSeams(result)[0]!.length).toBeCloseTo(80, 9);
    expect(measureSeams(result)).toHaveLength(6);
  });

  it('knows the height of flaps', () => {
    const result = cubeResult();
    addFlap(result, 2, 5);
    addFlap(result, 4, 2.5);
    const flaps = measureSeams(result).map(({ flap }) => Number(flap.toFixed(9)));
    expect(flaps).toEqual([0, 0, 5, 0, 2.5, 0, 0]);
  });

  it('knows how low the flaps are that have no room', () => {
    const result = cubeResult();
    [5, 3, 5, 2, 4].forEach((height, seam) => addFlap(result, seam, height));
    result.flaps = { ...result.flaps, wanted: 7, full: 2, shrunk: 3 };
    expect(shrunkHeights(result).map((mm) => Number(mm.toFixed(9)))).toEqual([2, 3, 4]);
  });

  it('looks at no flaps of seams that want none', () => {
    const result = scaled(cubeResult(), 0.1); // seams of 4 mm
    addFlap(result, 0, 1);
    result.flaps = { ...result.flaps, shrunk: 1 };
    expect(shrunkHeights(result)).toEqual([]);
  });
});

describe.skipIf(!isEngineBuilt)('seams of the engine', () => {
  it('have the flaps that it counts', async () => {
    const size = { sizing: 'height', size: 60 } as const;
    const result = await engineResult(objText(wavyRing(12)), { parts: 3, ...size });
    const { full, shrunk, wanted_mm } = result.flaps;
    const seams = measureSeams(result).filter(({ isJoint, length }) => !isJoint && length > 4);
    const low = seams.filter(({ flap }) => flap > 0 && flap < 5 - 1e-9);
    expect(shrunk).toBeGreaterThan(0);
    expect(low).toHaveLength(shrunk);
    expect(seams.filter(({ flap }) => flap >= 5 - 1e-9)).toHaveLength(full);
    expect(shrunkHeights(result)).toEqual(low.map(({ flap }) => flap).sort((a, b) => a - b));
    expect(seams.reduce((sum, { length }) => sum + length, 0)).toBeCloseTo(wanted_mm, 6);
  });
});
