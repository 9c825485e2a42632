import { describe, expect, it } from 'vitest';
import { edgeLength } from '../../web/model/borders.js';
import { hasPlaces, placesOf } from '../../web/model/finding-places.js';
import type { JobResult } from '../../web/model/job.js';
import { SheetEdges } from '../../web/model/sheet-edges.js';
import { findingsOn, type FindingCode } from '../../web/model/verdict.js';
import { addFlap, scaled } from './changed-result.js';
import { boxAndLidResult } from './fixtures.js';

/** The seams of the edges, and the names of the pieces, to which a finding leads. */
function placesIn(result: JobResult, code: FindingCode): (string | undefined)[] {
  const finding = findingsOn(result, 10).find((one) => one.code === code)!;
  return placesOf(finding, new SheetEdges(result)).map(({ edge, piece }) =>
    edge ? edge.seam?.name : result.pieces[piece]!.name,
  );
}

describe('the places of what is found', () => {
  it('are the seams that are too short, the shortest first', () => {
    const result = scaled(boxAndLidResult(), 0.2);
    const seams = result.seams.map(({ name }) => name);
    expect(placesIn(result, 'short-seams').sort()).toEqual(seams.sort());
    expect(placesIn(boxAndLidResult(), 'short-seams')).toEqual([]);
  });

  it('are the seams without a flap or a number', () => {
    const result = boxAndLidResult();
    const [bare, ...others] = result.seams.map((_, i) => i);
    for (const seam of others) addFlap(result, seam, 5);
    const { name } = result.seams[bare!]!;
    expect(placesIn(result, 'missing-flaps')).toEqual([name]);
    result.ids = { printed: 7, skipped: [name] };
    expect(placesIn(result, 'missing-numbers')).toEqual([name]);
  });

  it('are pieces where these are the matter', () => {
    const result = boxAndLidResult();
    result.pieces[1] = { ...result.pieces[1]!, labels: [], width: 5, height: 5 };
    expect(placesIn(result, 'missing-names')).toEqual(['B']);
    expect(placesIn(result, 'tiny-pieces')).toEqual(['B']);
    expect(placesIn(result, 'spare-sheet')).toEqual(['B']);
    expect(placesIn(result, 'long-building')).toEqual([]);
    // Whoever is offered to be led there is led somewhere.
    const edges = new SheetEdges(result);
    for (const finding of findingsOn(result, 10).filter(hasPlaces)) {
      expect([finding.code, placesOf(finding, edges).length]).not.toContain(0);
    }
  });

  it('are the folds that are as long as the necks, or the piece if none is', () => {
    const withNeck = (length: number): JobResult => {
      const result = boxAndLidResult();
      result.pieces[0] = { ...result.pieces[0]!, necks: Float64Array.of(length) };
      return result;
    };
    const neck = withNeck(40);
    const edges = new SheetEdges(neck);
    const finding = findingsOn(neck, 10).find(({ code }) => code === 'weak-necks')!;
    const folds = placesOf(finding, edges).map(({ edge }) => edge!);
    expect(folds.length).toBeGreaterThan(0);
    for (const { kind, piece, edge } of folds) {
      expect(kind).toBe('mountain');
      expect(edgeLength(neck.pieces[piece]!, edge)).toBeCloseTo(40, 9);
    }
    expect(placesIn(withNeck(3), 'weak-necks')).toEqual(['A']);
  });
});
