import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { bodiesOf } from '../../web/model/body.js';
import { ballOf } from '../../web/model/bounds.js';
import { choreograph, foldEnd, poseOn, type Track } from '../../web/model/choreography.js';
import { foldTree } from '../../web/model/fold-tree.js';
import { foldedVertices, modelPose } from '../../web/model/folded-piece.js';
import type { JobResult } from '../../web/model/job.js';
import { joinOrder } from '../../web/model/join-order.js';
import { noTurn, posed, turnAround, turnBack, turned } from '../../web/model/pose.js';
import { layInRows } from '../../web/model/row-layout.js';
import { length, minus, vectorAt, type Vector } from '../../web/model/vector.js';
import { wayOut } from '../../web/model/way-out.js';
import { sharedFolder } from './command.js';
import { countCrossings, type Triangle } from './crossings.js';
import { engineResult } from './engine-result.js';
import { boxAndLidResult, cubeResult } from './fixtures.js';
import { isEngineBuilt } from './thread-pool.js';

const shared = sharedFolder();

/** Turns sheets so that they lie on the ground. */
const ground = turnAround([1, 0, 0], -Math.PI / 2);

/** The pieces of a result at any time of their way. */
function stage(result: JobResult, table = ground) {
  const trees = result.pieces.map(foldTree);
  const tracks = choreograph(bodiesOf(result, trees), ballOf(result.model.vertices), table);
  const vertices = (piece: number, time: number): Vector[] => {
    const shape = foldedVertices(result.pieces[piece]!, trees[piece]!, Math.min(1, time / foldEnd));
    const pose = poseOn(tracks[piece]!, time);
    return Array.from({ length: shape.length / 3 }, (_, i) => posed(pose, vectorAt(shape, i)));
  };
  const triangles = (piece: number, time: number): Triangle[] => {
    const points = vertices(piece, time);
    const { faces, sources } = result.pieces[piece]!;
    const corner = (face: number, i: number): Vector => points[faces[3 * face + i]!]!;
    return Array.from(sources, (_, face) => [corner(face, 0), corner(face, 1), corner(face, 2)]);
  };
  return { tracks, vertices, triangles };
}

/** The crossings of different pieces, added up over evenly spaced times. */
function crossingsOf(result: JobResult, looks: number): number {
  const { triangles } = stage(result);
  let count = 0;
  for (let look = 0; look <= looks; ++look) {
    const all = result.pieces.map((_, piece) => triangles(piece, look / looks));
    all.forEach((a, i) => {
      for (const b of all.slice(0, i)) count += countCrossings(a, b);
    });
  }
  return count;
}

describe('joinOrder', () => {
  it('starts with the largest piece and says what is glued to what', () => {
    expect(joinOrder(boxAndLidResult().pieces)).toEqual([
      { piece: 0, partners: [] },
      { piece: 1, partners: [0] },
    ]);
  });

  it('takes the piece with the longest border next', () => {
    const [box, lid] = boxAndLidResult().pieces;
    // Two lids that share different edges with the box, and none with each other.
    const lidAt = (shared: number[], others: number) => ({
      ...lid!,
      modelEdges: lid!.modelEdges.map((edge, i) => (shared.includes(i) ? edge : others + i)),
    });
    expect(joinOrder([lidAt([1], 100), lidAt([2, 3], 200), box!])).toEqual([
      { piece: 2, partners: [] },
      { piece: 1, partners: [2] },
      { piece: 0, partners: [2] },
    ]);
  });
});

describe('layInRows', () => {
  const boxes = [10, 40, 20, 30, 10, 25].map((side, i) => ({ width: side, height: side + i }));
  const spots = layInRows(boxes, 1.5, 2);

  it('lays nothing over each other', () => {
    spots.forEach((a, i) => {
      spots.slice(0, i).forEach((b, j) => {
        const [p, q] = [boxes[i]!, boxes[j]!];
        const beside = a.x >= b.x + q.width + 2 || b.x >= a.x + p.width + 2;
        const above = a.y >= b.y + q.height + 2 || b.y >= a.y + p.height + 2;
        expect(beside || above).toBe(true);
      });
    });
  });

  it('has its middle at the origin', () => {
    const right = Math.max(...spots.map(({ x }, i) => x + boxes[i]!.width));
    const top = Math.max(...spots.map(({ y }, i) => y + boxes[i]!.height));
    expect(Math.min(...spots.map(({ x }) => x))).toBeCloseTo(-right, 12);
    expect(Math.min(...spots.map(({ y }) => y))).toBeCloseTo(-top, 12);
  });
});

describe('wayOut', () => {
  /** An open box: drawn out of it, something can only go up. */
  const walls: Vector[] = [
    [-1, -1, 0],
    [1, -1, 0],
    [1, 1, 0],
    [-1, 1, 0],
  ];
  const box = walls.flatMap((a, i) => {
    const b = walls[(i + 1) % 4]!;
    return [a, b, [b[0], b[1], 4], a, [b[0], b[1], 4], [a[0], a[1], 4]].flat();
  });
  const floor = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0];

  it('leads out of a box', () => {
    // It faces a wall.
    const inside = Float64Array.of(0, -0.5, 0.5, 0, 0.5, 0.5, 0, 0, 1);
    const way = wayOut(inside, Float64Array.from([...box, ...floor]));
    expect(way[2]).toBeGreaterThan(0.9);
  });

  it('is where the piece faces if nothing is in the way', () => {
    expect(wayOut(Float64Array.from(floor), new Float64Array())).toEqual([0, 0, 1]);
  });
});

describe('choreograph', () => {
  it.each([
    ['cube', cubeResult()],
    ['box and lid', boxAndLidResult()],
  ])('lays the %s flat on the table at first, side by side', (_, result) => {
    for (const table of [ground, noTurn, turnAround([0, 0, 1], 1)]) {
      const { vertices } = stage(result, table);
      const flat = result.pieces.map((_, piece) =>
        vertices(piece, 0).map((point) => turned(turnBack(table), point)),
      );
      const height = flat[0]![0]![2];
      for (const [, , z] of flat.flat()) expect(z).toBeCloseTo(height, 9);
    }
    const { triangles } = stage(result, noTurn);
    const all = result.pieces.flatMap((_, piece) => triangles(piece, 0));
    const right = ([a, b, c]: Triangle) =>
      (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    // Seen from above the printed side is up.
    for (const triangle of all) expect(right(triangle)).toBeGreaterThan(0);
  });

  it('ends in the model', () => {
    const result = boxAndLidResult();
    const { tracks } = stage(result);
    result.pieces.forEach((piece, i) => {
      expect(poseOn(tracks[i]!, 1)).toEqual(modelPose(piece, foldTree(piece), result.model));
    });
  });

  it('moves without jumps, and only after all is folded', () => {
    const distance = (track: Track, from: number, to: number): number => {
      const [a, b] = [poseOn(track, from), poseOn(track, to)];
      return length(minus(posed(a, [20, 20, 0]), posed(b, [20, 20, 0])));
    };
    for (const track of stage(boxAndLidResult()).tracks) {
      expect(distance(track, 0, foldEnd)).toBeCloseTo(0, 12);
      for (let time = foldEnd; time < 1; time += 1e-4) {
        expect(distance(track, time, time + 1e-4)).toBeLessThan(4);
      }
    }
  });

  it('brings one piece after the other, in the order of their joining', () => {
    const result = boxAndLidResult();
    const ends = (track: Track) => track.times.at(-1)!;
    const { tracks } = stage(result);
    const inTurn = joinOrder(result.pieces).map(({ piece }) => ends(tracks[piece]!));
    expect(inTurn).toEqual([...inTurn].sort((a, b) => a - b));
    expect(inTurn.at(-1)).toBeCloseTo(1, 12);
  });

  it('lets no piece pass through another', () => {
    expect(crossingsOf(boxAndLidResult(), 100)).toBe(0);
  });

  it.skipIf(!isEngineBuilt || shared === null)(
    'lets no part of a cat pass through another',
    async () => {
      const cat = readFileSync(join(shared!, 'models/organic/cat_300.obj'), 'utf8');
      const result = await engineResult(cat, { parts: 6 });
      expect(crossingsOf(result, 150)).toBe(0);
    },
  );
});
