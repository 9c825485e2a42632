import { describe, expect, it } from 'vitest';
import { assemblySteps } from '../../web/model/assembly-steps.js';
import { foldTree } from '../../web/model/fold-tree.js';
import type { Piece } from '../../web/model/job.js';
import { seamsOf } from '../../web/model/seams.js';
import { engineResult } from './engine-result.js';
import { beakResult, boxAndLidResult, cubeResult, slitResult } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { isEngineBuilt } from './thread-pool.js';

const cutsOf = ({ assignments }: Piece) => [...assignments].filter((kind) => kind === 'B').length;

/** Every cut edge once, and the two of a pair from the same edge of the model. */
function expectAllClosed(piece: Piece): void {
  const pairs = seamsOf(piece, foldTree(piece)).flat();
  expect(new Set(pairs.flat()).size).toBe(2 * pairs.length);
  for (const [a, b] of pairs) expect(piece.modelEdges[a]).toBe(piece.modelEdges[b]);
}

/** How many of the pairs touch what is closed before them, at either end. */
function begunPairs(piece: Piece): number {
  const at = (vertex: number) => `${piece.vertices[2 * vertex]} ${piece.vertices[2 * vertex + 1]}`;
  const met = new Map<string, string>();
  const of = (place: string): string => (met.has(place) ? of(met.get(place)!) : place);
  let begun = 0;
  for (const [a, b] of seamsOf(piece, foldTree(piece)).flat()) {
    const [from, to] = [at(piece.edges[2 * a]!), at(piece.edges[2 * a + 1]!)];
    const [start, end] = [at(piece.edges[2 * b]!), at(piece.edges[2 * b + 1]!)];
    if (of(from) === of(end) || of(to) === of(start)) ++begun;
    if (of(from) !== of(end)) met.set(of(from), of(end));
    if (of(to) !== of(start)) met.set(of(to), of(start));
  }
  return begun;
}

describe('seamsOf', () => {
  it('closes the seven cuts of a cube, each beside what is closed', () => {
    const [piece] = cubeResult().pieces;
    expectAllClosed(piece!);
    expect(seamsOf(piece!, foldTree(piece!)).flat()).toHaveLength(7);
    expect(cutsOf(piece!)).toBe(14);
    expect(begunPairs(piece!)).toBe(7);
  });

  it('begins in the middle', () => {
    const [piece] = cubeResult().pieces;
    const { depths } = foldTree(piece!);
    const depthOf = (edge: number) => {
      const ends = piece!.edges.subarray(2 * edge, 2 * edge + 2);
      const faces = [...depths.keys()].filter((face) =>
        ends.every((end) => piece!.faces.subarray(3 * face, 3 * face + 3).includes(end)),
      );
      return depths[faces[0]!]!;
    };
    const starts = seamsOf(piece!, foldTree(piece!)).map(([pair]) => pair!);
    const distances = starts.map(([a, b]) => depthOf(a) + depthOf(b));
    expect(distances[0]).toBe(Math.min(...distances));
  });

  it('closes a slit from its end', () => {
    const [piece] = slitResult().pieces;
    expect(seamsOf(piece!, foldTree(piece!))).toHaveLength(1);
    expect(begunPairs(piece!)).toBe(1);
  });

  it('has nothing to do where all cuts lead to other pieces', () => {
    const [, lid] = boxAndLidResult().pieces;
    expect(seamsOf(lid!, foldTree(lid!))).toEqual([]);
  });

  it.skipIf(!isEngineBuilt)('closes nets of the engine bit by bit', async () => {
    const { pieces } = await engineResult(objText(wavyRing(10)), { parts: 3 });
    for (const piece of pieces) {
      expectAllClosed(piece);
      const seams = seamsOf(piece, foldTree(piece));
      // Where a part goes once around the ring's tube, its last seam begins nowhere.
      expect(seams.flat().length - begunPairs(piece)).toBeLessThanOrEqual(1);
    }
  });
});

describe('assemblySteps', () => {
  it('folds the largest piece first and glues the others to it', () => {
    const [first, second, ...more] = assemblySteps(boxAndLidResult().pieces);
    expect(more).toEqual([]);
    expect(first).toMatchObject({ piece: 0, folds: 4, crease: 'mountain', turn: [], partners: [] });
    expect(first!.borders).toEqual([]);
    expect(second).toMatchObject({ piece: 1, folds: 0, seams: [], partners: [0] });
    expect(second!.borders).toHaveLength(4);
    for (const pair of second!.borders) {
      expect(pair.map(({ piece }) => piece).sort()).toEqual([0, 1]);
    }
  });

  it('names the few folds that go the other way', () => {
    const { pieces } = beakResult();
    const [piece] = pieces;
    const { crease, turn, folds } = assemblySteps(pieces)[0]!;
    expect(folds).toBe(3);
    const kinds = [...piece!.assignments].filter((kind) => kind !== 'B');
    const few = kinds.filter((kind) => kind === 'V').length < 2 ? 'V' : 'M';
    expect(crease).toBe(few === 'V' ? 'mountain' : 'valley');
    expect(turn.map((edge) => piece!.assignments[edge])).toEqual([few]);
  });

  it('leaves out folds that are not drawn', () => {
    const { pieces } = cubeResult();
    expect(assemblySteps(pieces, 91)[0]).toMatchObject({ folds: 0, turn: [] });
  });
});
