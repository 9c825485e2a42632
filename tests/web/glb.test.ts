import { validateBytes } from 'gltf-validator';
import { AnimationMixer, LoopOnce, Mesh, Vector3, type Object3D } from 'three';
import { GLTFLoader, type GLTF } from 'three/addons/loaders/GLTFLoader.js';
import { describe, expect, it } from 'vitest';
import { writeGlb } from '../../web/export/glb.js';
import type { JobResult } from '../../web/model/job.js';
import { engineResult } from './engine-result.js';
import { boxAndLidResult, cubeResult, slitResult, tetrahedronResult } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { isEngineBuilt } from './thread-pool.js';

const results = {
  cube: cubeResult(),
  'box and lid': boxAndLidResult(),
  slit: slitResult(),
  tetrahedron: tetrahedronResult(),
};

const mm = 0.001;

/** A file as another program sees it. */
class Played {
  private readonly mixer: AnimationMixer;

  private constructor(private readonly gltf: GLTF) {
    this.mixer = new AnimationMixer(gltf.scene);
    const action = this.mixer.clipAction(gltf.animations[0]!).setLoop(LoopOnce, 1);
    action.clampWhenFinished = true;
    action.play();
  }

  static async from(result: JobResult): Promise<Played> {
    const bytes = Uint8Array.from(writeGlb(result));
    return new Played(await new GLTFLoader().parseAsync(bytes.buffer, ''));
  }

  get seconds(): number {
    return this.gltf.animations[0]!.duration;
  }

  /** Corners of all triangles in mm, by piece, at a share of the animation. */
  at(share: number): Vector3[][] {
    this.mixer.setTime(share * this.seconds);
    this.gltf.scene.updateMatrixWorld(true);
    return this.gltf.scene.children.map((piece) => cornersOf(piece));
  }
}

interface Written {
  materials: { pbrMetallicRoughness: { baseColorFactor: number[] } }[];
}

/** The properties of a file, from its first chunk. */
function propertiesOf(file: Uint8Array): Written {
  const length = new DataView(file.buffer, file.byteOffset).getUint32(12, true);
  return JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + length))) as Written;
}

function cornersOf(piece: Object3D): Vector3[] {
  const corners: Vector3[] = [];
  piece.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const position = (object as Mesh).geometry.getAttribute('position');
    for (let i = 0; i < position.count; ++i) {
      const corner = new Vector3().fromBufferAttribute(position, i);
      corners.push(corner.applyMatrix4(object.matrixWorld).divideScalar(mm));
    }
  });
  return corners;
}

/** The triangles as texts that are the same for the same places, in mm to three decimals. */
function trianglesOf(corners: Vector3[]): string[] {
  const texts = corners.map(({ x, y, z }) =>
    [x, y, z].map((value) => (Math.round(value * 1000) / 1000 + 0).toFixed(3)).join(' '),
  );
  return Array.from({ length: texts.length / 3 }, (_, i) => {
    const three = texts.slice(3 * i, 3 * i + 3);
    const first = three.indexOf([...three].sort()[0]!);
    return [...three.slice(first), ...three.slice(0, first)].join(', ');
  }).sort();
}

function modelTriangles({ model }: JobResult): string[] {
  return trianglesOf(
    Array.from(model.faces, (vertex) => new Vector3().fromArray(model.vertices, 3 * vertex)),
  );
}

/** The farthest that a corner is from the nearest vertex of the model, in mm. */
function worstCorner({ model }: JobResult, corners: Vector3[]): number {
  const vertices = Array.from({ length: model.vertices.length / 3 }, (_, i) =>
    new Vector3().fromArray(model.vertices, 3 * i),
  );
  const distances = corners.map((corner) =>
    Math.min(...vertices.map((vertex) => vertex.distanceTo(corner))),
  );
  return Math.max(...distances);
}

describe('writeGlb', () => {
  it.each(Object.entries(results))('writes a valid file of the %s', async (_, result) => {
    const { issues, info } = await validateBytes(writeGlb(result));
    expect(issues.messages).toEqual([]);
    expect(info.animationCount).toBe(1);
    expect(info.materialCount).toBe(result.parts);
    expect(info.totalTriangleCount).toBe(result.model.faces.length / 3);
  });

  it.each(Object.entries(results))('ends with the %s', async (_, result) => {
    const played = await Played.from(result);
    expect(trianglesOf(played.at(1).flat())).toEqual(modelTriangles(result));
  });

  it.each(Object.entries(results))('begins with the %s lying flat', async (_, result) => {
    const played = await Played.from(result);
    const pieces = played.at(0);
    const heights = pieces.flat().map(({ y }) => y);
    expect(Math.max(...heights) - Math.min(...heights)).toBeLessThan(1e-4);
    // Side by side: no box of one reaches into that of another.
    pieces.forEach((a, i) => {
      for (const b of pieces.slice(0, i)) {
        const apart = (['x', 'z'] as const).some((axis) => {
          const [p, q] = [a, b].map((corners) => corners.map((corner) => corner[axis]));
          return Math.min(...p!) > Math.max(...q!) || Math.min(...q!) > Math.max(...p!);
        });
        expect(apart).toBe(true);
      }
    });
  });

  it('folds in between', async () => {
    const played = await Played.from(results.cube);
    const heights = played
      .at(0.5)
      .flat()
      .map(({ y }) => y);
    expect(Math.max(...heights) - Math.min(...heights)).toBeGreaterThan(20);
  });

  it('gives parts their colours', () => {
    const { materials } = propertiesOf(writeGlb(results['box and lid']));
    const colours = materials.map(({ pbrMetallicRoughness }) =>
      pbrMetallicRoughness.baseColorFactor.map((value) => Number(value.toFixed(3))),
    );
    // Of the palette's sky blue and orange with half white.
    expect(colours).toEqual([
      [0.407, 0.701, 0.905, 1],
      [0.896, 0.624, 0.216, 1],
    ]);
  });

  it('is the same bytes every time', () => {
    expect(writeGlb(cubeResult())).toEqual(writeGlb(cubeResult()));
  });

  it('folds nets without a motion evenly', async () => {
    const result = cubeResult();
    for (const piece of result.pieces) delete piece.motion;
    const played = await Played.from(result);
    expect(trianglesOf(played.at(1).flat())).toEqual(modelTriangles(result));
  });

  it.skipIf(!isEngineBuilt)('holds for nets of the engine', async () => {
    const result = await engineResult(objText(wavyRing(10)), { parts: 3 });
    const { issues } = await validateBytes(writeGlb(result));
    expect(issues.messages).toEqual([]);
    const played = await Played.from(result);
    // Single precision through chains of hinges: some micrometres on a model as large as a hand.
    expect(worstCorner(result, played.at(1).flat())).toBeLessThan(0.005);
    const heights = played
      .at(0)
      .flat()
      .map(({ y }) => y);
    expect(Math.max(...heights) - Math.min(...heights)).toBeLessThan(0.001);
  });
});
