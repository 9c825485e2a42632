import { describe, expect, it } from 'vitest';
import { anglesAt } from '../../web/model/fold-motion.js';
import { foldTree } from '../../web/model/fold-tree.js';
import { flatVertex, foldedVertices, modelPose } from '../../web/model/folded-piece.js';
import type { JobResult, Model, Piece } from '../../web/model/job.js';
import { posed } from '../../web/model/pose.js';
import { length, minus, vectorAt } from '../../web/model/vector.js';
import { engineResult } from './engine-result.js';
import {
  beakResult,
  boxAndLidResult,
  cubeResult,
  slitResult,
  tetrahedronResult,
} from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { isEngineBuilt } from './thread-pool.js';

const results = {
  cube: cubeResult(),
  'box and lid': boxAndLidResult(),
  slit: slitResult(),
  beak: beakResult(),
  tetrahedron: tetrahedronResult(),
};

/** The farthest that a corner of the folded piece is from its place in the model. */
function worstCorner(piece: Piece, model: Model): number {
  const tree = foldTree(piece);
  const folded = foldedVertices(piece, tree, 1);
  const home = modelPose(piece, tree, model);
  let worst = 0;
  piece.faces.forEach((vertex, at) => {
    const source = 3 * piece.sources[Math.floor(at / 3)]! + (at % 3);
    const wanted = vectorAt(model.vertices, model.faces[source]!);
    worst = Math.max(worst, length(minus(posed(home, vectorAt(folded, vertex)), wanted)));
  });
  return worst;
}

function expectModel({ pieces, model }: JobResult): void {
  const extent = model.vertices.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  for (const piece of pieces) expect(worstCorner(piece, model)).toBeLessThan(1e-6 * extent);
}

describe('foldTree', () => {
  const { pieces } = results.cube;
  const tree = foldTree(pieces[0]!);

  it('reaches every face once, after the face that it hangs on', () => {
    expect([...tree.order].sort((a, b) => a - b)).toEqual(Array.from({ length: 12 }, (_, i) => i));
    const place = [...tree.order].map((_, face) => tree.order.indexOf(face));
    tree.parents.forEach((parent, face) => {
      if (face !== tree.order[0]) expect(place[parent]).toBeLessThan(place[face]!);
    });
  });

  it('names the edge that joins the two faces', () => {
    const { faces, edges } = pieces[0]!;
    tree.parents.forEach((parent, face) => {
      if (parent < 0) return;
      const ends = [...edges.subarray(2 * tree.edges[face]!, 2 * tree.edges[face]! + 2)];
      for (const one of [face, parent]) {
        expect([...faces.subarray(3 * one, 3 * one + 3)]).toEqual(expect.arrayContaining(ends));
      }
      expect(ends).toContain(faces[3 * face + tree.corners[face]!]);
    });
  });

  it('counts edges from the root', () => {
    const piece = { ...pieces[0]!, motion: { ...pieces[0]!.motion!, root: 5 } };
    const { order, depths } = foldTree(piece);
    expect([order[0], depths[5]]).toEqual([5, 0]);
    expect(Math.max(...depths)).toBeGreaterThan(2);
  });
});

describe('anglesAt', () => {
  const piece = results.beak.pieces[0]!;

  it('goes linearly from key to key', () => {
    const { foldAngles } = piece;
    const ahead = foldAngles.map((angle, edge) => (edge === 0 ? angle : 0));
    const angles = Float64Array.from([...foldAngles.map(() => 0), ...ahead, ...foldAngles]);
    const motion = { root: 0, times: Float64Array.of(0, 0.5, 1), angles };
    const [first, , third] = [...foldAngles];
    const expectAt = (time: number, wanted: number[]) => {
      const found = anglesAt({ ...piece, motion }, time);
      wanted.forEach((angle, edge) => expect(found[edge]).toBeCloseTo(angle, 12));
    };
    expectAt(0, [0, 0, 0]);
    expectAt(0.25, [first! / 2, 0, 0]);
    expectAt(0.75, [first!, foldAngles[1]! / 2, third! / 2]);
    expectAt(1, [...foldAngles].slice(0, 3));
  });

  it('turns all folds evenly where there is no motion', () => {
    const { motion: _, ...unknown } = piece;
    const quarter = [...anglesAt(unknown, 0.25)];
    quarter.forEach((angle, edge) => {
      expect(angle).toBe(piece.assignments[edge] === 'B' ? 0 : piece.foldAngles[edge]! / 4);
    });
  });
});

describe('foldedVertices', () => {
  it('lies on the sheet at first', () => {
    const [piece] = results.cube.pieces;
    const folded = foldedVertices(piece!, foldTree(piece!), 0);
    for (let vertex = 0; vertex < folded.length / 3; ++vertex) {
      expect(length(minus(vectorAt(folded, vertex), flatVertex(piece!, vertex)))).toBeLessThan(
        1e-9,
      );
    }
  });

  it.each(Object.entries(results))('is the %s in the end', (_, result) => expectModel(result));

  it('takes mountains down, away from the printed side, and valleys up', () => {
    const lowest = (piece: Piece) => Math.min(...foldedVertices(piece, foldTree(piece), 0.5));
    expect(lowest(results.cube.pieces[0]!)).toBeLessThan(-10);
    expect(lowest(results.slit.pieces[0]!)).toBeGreaterThan(-1e-9);
  });

  it('does not need a motion', () => {
    const { model, pieces } = results.cube;
    const { motion: _, ...unknown } = pieces[0]!;
    expect(worstCorner(unknown, model)).toBeLessThan(1e-6);
  });

  it.skipIf(!isEngineBuilt)('is the model for nets of the engine', async () => {
    const result = await engineResult(objText(wavyRing(10)), { parts: 3 });
    expect(result.pieces.every(({ motion }) => motion)).toBe(true);
    expectModel(result);
  });
});
