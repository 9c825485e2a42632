import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { flightTimes, foldEnd } from '../../web/model/choreography.js';
import type { JobResult } from '../../web/model/job.js';
import { turnAround } from '../../web/model/pose.js';
import { dot, vectorAt, type Vector } from '../../web/model/vector.js';
import { FoldingStage, type Beholder } from '../../web/view/folding-stage.js';
import { boxSeen, viewAxes } from '../../web/view/camera-path.js';
import { extentOf, flatMesh } from '../../web/view/model-geometry.js';
import { Orbit, viewHeight } from '../../web/view/orbit.js';
import { boxAndLidResult, cubeResult, slitResult } from './fixtures.js';

const results = { cube: cubeResult(), 'box and lid': boxAndLidResult(), slit: slitResult() };

/** Someone looks from this angle around the upright axis. */
const around = 0.65;

const beholder: Beholder = { around, height: viewHeight, aspect: 1.6 };

function stageOf(result: JobResult, from = beholder) {
  const stage = new FoldingStage(result);
  stage.turnTable(from);
  const count = 3 * result.model.faces.length;
  return {
    netVertices: stage.netVertices,
    at(time: number) {
      const [positions, normals] = [new Float32Array(count), new Float32Array(count)];
      const extent = stage.write(time, positions, normals);
      return { positions, normals, extent };
    },
  };
}

const points = (values: Float32Array): Vector[] =>
  Array.from({ length: values.length / 3 }, (_, i) => vectorAt(values, i));

describe('FoldingStage', () => {
  it.each(Object.entries(results))('ends with the %s as it was shown before', (_, result) => {
    const { positions, normals, extent } = stageOf(result).at(1);
    const { model } = result;
    const shown = flatMesh(model.vertices, model.faces);
    positions.forEach((value, i) => expect(value).toBeCloseTo(shown.positions[i]!, 5));
    normals.forEach((value, i) => expect(value).toBeCloseTo(shown.normals[i]!, 5));
    const wanted = extentOf(shown.positions, viewHeight);
    expect(extent.up).toBeCloseTo(wanted.up, 5);
    expect(extent.reach).toBeCloseTo(wanted.reach, 5);
  });

  it.each(Object.entries(results))(
    'begins with the %s flat, its outside to the front',
    (_, result) => {
      const { positions, normals } = stageOf(result).at(0);
      const [front] = points(normals);
      for (const normal of points(normals)) expect(dot(normal, front!)).toBeCloseTo(1, 6);
      // Towards the one who looks, and a little up.
      expect(dot(front!, [Math.sin(around), 0, Math.cos(around)])).toBeGreaterThan(0.5);
      expect(front![1]).toBeGreaterThan(0);
      const depths = points(positions).map((point) => dot(point, front!));
      expect(Math.max(...depths) - Math.min(...depths)).toBeLessThan(1e-5);
    },
  );

  /** How far the corners of some faces reach in a view at a time, as a share of half of it; 1 is its edge. */
  function fill(result: JobResult, time: number, faces: (face: number) => boolean = () => true) {
    const camera = new PerspectiveCamera();
    const orbit = new Orbit(camera);
    orbit.fit(1.3);
    const { vertices, faces: corners } = result.model;
    orbit.reset(extentOf(flatMesh(vertices, corners).positions, viewHeight));
    const { positions, extent } = stageOf(result, orbit).at(time);
    orbit.frame(extent);
    camera.updateMatrixWorld();
    const seen = points(positions)
      .filter((_, corner) => faces(Math.floor(corner / 3)))
      .map((point) => new Vector3(...point).project(camera));
    return Math.max(...seen.map(({ x, y }) => Math.max(Math.abs(x), Math.abs(y))));
  }

  it.each(Object.entries(results))('lets the %s fill the view while it folds', (_, result) => {
    for (const time of [0, 0.2, 0.5, foldEnd]) {
      const share = fill(result, time);
      expect(share).toBeLessThanOrEqual(1);
      expect(share).toBeGreaterThan(0.55);
    }
  });

  it('looks at what comes together, not at the table', () => {
    const result = results['box and lid'];
    const [box, lid] = result.pieces.map(({ sources }) => new Set(sources));
    const { end } = flightTimes(0, 2);
    // The lid has just begun to rise.
    const share = fill(result, end, (face) => box!.has(face));
    expect(share).toBeLessThanOrEqual(1);
    expect(share).toBeGreaterThan(0.5);
    // At its place it is in view.
    expect(fill(result, 0.98, (face) => lid!.has(face))).toBeLessThanOrEqual(1);
  });

  it('knows where things lie for someone who looks', () => {
    const [right, up, near] = viewAxes(0, 0);
    expect([right, up, near]).toEqual([
      [1, 0, -0],
      [-0, 1, -0],
      [0, 0, 1],
    ]);
    const { low, high } = boxSeen(Float64Array.of(1, 2, 3, -1, 0, 5), viewAxes(Math.PI / 2, 0));
    // From the side: what was in front is to the left.
    expect(low.map(Math.round)).toEqual([-5, 0, -1]);
    expect(high.map(Math.round)).toEqual([-3, 2, 1]);
    const pose = { turn: turnAround([0, 1, 0], Math.PI / 2), move: [10, 0, 0] } as const;
    const posedBox = boxSeen(Float64Array.of(1, 2, 3), viewAxes(0, 0), pose);
    expect(posedBox.low.map(Math.round)).toEqual([13, 2, -1]);
  });

  it('moves nothing by leaps', () => {
    const stage = stageOf(results['box and lid']);
    let before = points(stage.at(0).positions);
    for (let step = 1; step <= 500; ++step) {
      const now = points(stage.at(step / 500).positions);
      const leaps = now.map((point, i) => Math.hypot(...point.map((x, k) => x - before[i]![k]!)));
      expect(Math.max(...leaps)).toBeLessThan(0.15);
      before = now;
    }
  });

  it('goes back to where it was', () => {
    const stage = stageOf(results.cube);
    const first = stage.at(0.3).positions;
    stage.at(0.9);
    expect(stage.at(0.3).positions).toEqual(first);
  });

  it('knows the vertices of the nets, which no two pieces share', () => {
    const result = results['box and lid'];
    const { netVertices } = stageOf(result);
    const ofPiece = result.pieces.map(
      ({ sources }) =>
        new Set([...sources].flatMap((face) => [...netVertices.slice(3 * face, 3 * face + 3)])),
    );
    const counts = result.pieces.map(({ vertices }) => vertices.length / 2);
    expect(ofPiece.map(({ size }) => size)).toEqual(counts);
    expect(new Set(netVertices).size).toBe(counts[0]! + counts[1]!);
  });
});
