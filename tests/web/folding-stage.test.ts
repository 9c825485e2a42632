import { describe, expect, it } from 'vitest';
import { foldEnd } from '../../web/model/choreography.js';
import type { JobResult } from '../../web/model/job.js';
import { dot, vectorAt, type Vector } from '../../web/model/vector.js';
import { FoldingStage } from '../../web/view/folding-stage.js';
import { extentOf, extentSeen, flatMesh } from '../../web/view/model-geometry.js';
import { viewHeight } from '../../web/view/orbit.js';
import { boxAndLidResult, cubeResult, slitResult } from './fixtures.js';

const results = { cube: cubeResult(), 'box and lid': boxAndLidResult(), slit: slitResult() };

/** Someone looks from this angle around the upright axis. */
const around = 0.65;

function stageOf(result: JobResult) {
  const stage = new FoldingStage(result);
  stage.turnTable(around);
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

  it('keeps all in view while the pieces fold', () => {
    const stage = stageOf(results['box and lid']);
    for (const time of [0, 0.2, 0.5, foldEnd]) {
      const { positions, extent } = stage.at(time);
      const seen = extentSeen(positions, viewHeight, around);
      expect(seen.up).toBeLessThan(extent.up + 1e-6);
      expect(seen.reach).toBeLessThan(extent.reach + 1e-6);
    }
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
