import {
  EXTMeshoptCompression,
  KHRDracoMeshCompression,
  KHRMeshQuantization,
} from '@gltf-transform/extensions';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { describe, expect, it } from 'vitest';
import type { ModelFile } from '../../web/model/model-files.js';
import { encoded, Scene } from './gltf-files.js';
import { changed, codesOf, read, refusal, sizeOf, trianglesOf, volumeOf } from './read-model.js';
import { box } from './solids.js';

const half = Math.SQRT1_2;

async function glb(scene: Scene): Promise<ModelFile> {
  return { name: 'model.glb', bytes: await scene.glb() };
}

/** Volume and size of what a scene gives. */
async function measured(scene: Scene): Promise<{ volume: number; size: number[] }> {
  const { file } = await read(await glb(scene));
  const triangles = trianglesOf(file);
  return { volume: Number(volumeOf(triangles).toFixed(3)), size: sizeOf(triangles) };
}

describe('nodes of a glTF scene', () => {
  it('stand where those that hold them put them', async () => {
    const scene = new Scene();
    const outer = scene
      .add(box(1, 2, 3))
      .setTranslation([10, 0, 0])
      .setScale([2, 2, 2]);
    scene
      .add(box(1, 1, 1), 4, outer)
      .setTranslation([1, 0, 0])
      .setRotation([0, 0, half, half]);
    expect(await measured(scene)).toEqual({ volume: 56, size: [2, 4, 6] });
  });

  it('keep their outsides outside where they are mirrored', async () => {
    const scene = new Scene();
    scene.add(box(1, 2, 3));
    scene.add(box(1, 2, 3)).setScale([-1, 1, 1]);
    scene
      .add(box(1, 1, 1))
      .setTranslation([5, 0, 0])
      .setScale([-1, -2, 1]);
    expect(await measured(scene)).toEqual({ volume: 14, size: [6, 4, 3] });
  });

  it('are all shown where there is no scene, and refused where they hold each other', async () => {
    const scene = new Scene();
    scene.add(box(1, 1, 1), 4, scene.add(box(1, 1, 1)));
    const { json, bin } = await scene.separate();
    const files = (nodes: object[]): ModelFile[] => [
      { name: 'a.gltf', bytes: encoded({ ...json, scenes: [], nodes }) },
      { name: 'data.bin', bytes: bin },
    ];
    const shown = await read(...files([{ mesh: 0, children: [1] }, { mesh: 1 }]));
    expect(trianglesOf(shown.file).corners).toHaveLength(72);
    const circle = { scenes: [{ nodes: [0] }], nodes: [{ children: [1, 1] }, { children: [0] }] };
    const bytes = encoded({ ...json, ...circle });
    expect(await refusal([{ name: 'a.gltf', bytes }])).toMatch(
      /nodes that hold each other without end/,
    );
  });
});

describe('primitives of glTF', () => {
  const square = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];

  it('give the same triangles as lists, strips and fans', async () => {
    for (const [mode, corners] of [
      [4, [0, 1, 2, 2, 1, 3]],
      [5, [0, 1, 2, 3]],
      [6, [0, 1, 3, 2]],
    ] as const) {
      const scene = new Scene();
      scene.add({ positions: square, corners: [...corners] }, mode);
      const { positions, corners: found } = trianglesOf((await read(await glb(scene))).file);
      expect(found).toHaveLength(6);
      const areas = [0, 3].map((at) => {
        const [a, b, c] = found.slice(at, at + 3).map((i) => positions.slice(3 * i, 3 * i + 2));
        return (b![0]! - a![0]!) * (c![1]! - a![1]!) - (b![1]! - a![1]!) * (c![0]! - a![0]!);
      });
      expect(areas).toEqual([1, 1]);
    }
  });

  it('that do not fold are counted', async () => {
    const scene = new Scene();
    scene.add(box(1, 1, 1));
    scene.add({ positions: square, corners: [0, 1, 2] }, 0);
    scene.add({ positions: square, corners: [0, 1, 2] }, 3);
    const { notices } = await read(await glb(scene));
    const params = { count: 5, points: 3, lines: 2, curves: 0, surfaces: 0 };
    expect(notices).toEqual([{ code: 'ignored-elements', params }]);
  });

  it('are refused with an index beyond their vertices, and with a place that is no number', async () => {
    const scene = new Scene();
    scene.add({ positions: square, corners: [0, 1, 7] });
    expect(await refusal([await glb(scene)])).toMatch(/^face 0: face refers to vertex 7/);
    const other = new Scene();
    other.add({ positions: [0, 0, 0, 1, NaN, 0, 0, 1, 0], corners: [0, 1, 2] });
    expect(await refusal([await glb(other)])).toBe('vertex 1: a coordinate is not a finite number');
  });
});

describe('what a glTF file carries beside its shape', () => {
  it('is told once', async () => {
    const scene = new Scene();
    const node = scene.add(box(1, 1, 1));
    const { document } = scene;
    document.createAnimation();
    document.createCamera();
    node.getMesh()!.listPrimitives()[0]!.setMaterial(document.createMaterial());
    const model = await read(await glb(scene));
    expect(codesOf(model)).toEqual(['unused-content']);
    expect(model.notices[0]!.params).toMatchObject({ animations: 1, cameras: 1, morphs: 0 });
    expect(model.usual).toEqual({ up: 'y', unit: 'm' });
  });

  it('may be an extension that is required and not known, as long as there is a shape', async () => {
    const scene = new Scene();
    scene.add(box(1, 1, 1));
    const { json, bin } = await scene.separate();
    const file = (more: object): ModelFile[] => [
      { name: 'a.gltf', bytes: encoded({ ...json, extensionsRequired: ['EXT_new'], ...more }) },
      { name: 'data.bin', bytes: bin },
    ];
    expect(codesOf(await read(...file({})))).toEqual(['unknown-extensions']);
    expect(await refusal(file({ nodes: [], scenes: [{}] }))).toMatch(
      /in a way that is not read \(EXT_new\)/,
    );
  });

  it('is the pose of a skeleton, which it stands in', async () => {
    const scene = new Scene();
    const node = scene.add(box(1, 1, 1));
    const joint = scene.document.createNode().setTranslation([0, 5, 0]).setScale([3, 1, 1]);
    scene.document.getRoot().listScenes()[0]!.addChild(joint);
    node.setSkin(scene.document.createSkin().addJoint(joint));
    node
      .getMesh()!
      .listPrimitives()[0]!
      .setAttribute('JOINTS_0', scene.list('VEC4', new Uint16Array(32)))
      .setAttribute(
        'WEIGHTS_0',
        scene.list(
          'VEC4',
          Float32Array.from({ length: 32 }, (_, i) => +(i % 4 === 0)),
        ),
      );
    const model = await read(await glb(scene));
    expect(codesOf(model)).toEqual(['posed-skins']);
    expect(sizeOf(trianglesOf(model.file))).toEqual([3, 1, 1]);
    expect(volumeOf(trianglesOf(model.file))).toBeCloseTo(3);
  });
});

describe('the buffers of a glTF file', () => {
  it('are found beside it, whatever folder it lies in, and named where they are missing', async () => {
    const scene = new Scene();
    scene.add(box(1, 2, 3));
    const { json, bin } = await scene.separate();
    const bytes = encoded({ ...json, buffers: [{ ...json.buffers![0], uri: './My%20Data.bin' }] });
    const model = { name: 'deep/a.gltf', bytes };
    for (const name of ['deep/My Data.bin', 'deep/my data.BIN']) {
      const found = await read(model, { name, bytes: bin });
      expect(volumeOf(trianglesOf(found.file))).toBeCloseTo(6);
      expect(found.notices).toEqual([]);
    }
    expect(await refusal([model])).toMatch(
      /^'deep\/a.gltf' needs .\/My Data.bin, which is missing/,
    );
    const short = { name: 'deep/My Data.bin', bytes: bin.subarray(0, 40) };
    expect(await refusal([model, short])).toMatch(/has only 40 of \d+ bytes of its data/);
  });

  it('may be written into its addresses', async () => {
    const scene = new Scene();
    scene.add(box(1, 2, 3));
    const { json, bin } = await scene.separate();
    const uri = `data:application/octet-stream;base64,${Buffer.from(bin).toString('base64')}`;
    const bytes = encoded({ ...json, buffers: [{ ...json.buffers![0], uri }] });
    const { file } = await read({ name: 'a.gltf', bytes });
    expect(volumeOf(trianglesOf(file))).toBeCloseTo(6);
  });
});

describe('the precision of glTF', () => {
  it('is that of floats', async () => {
    const scene = new Scene();
    scene.add(box(0.1, 0.2, 0.3)).setRotation([0, 0, half, half]);
    const { file } = await read(await glb(scene));
    expect(new TextDecoder().decode(file.bytes)).toContain('format binary_little_endian');
  });

  it('is that of the steps where positions are stored as integers', async () => {
    const scene = new Scene();
    const { positions, corners } = box(0.8, 0.4, 0.2);
    const node = scene.add({ positions, corners }).setScale([10, 10, 10]);
    const stored = Int16Array.from(positions, (value) => Math.round(32767 * value));
    scene.document.createExtension(KHRMeshQuantization).setRequired(true);
    const list = scene.list('VEC3', stored).setNormalized(true);
    node.getMesh()!.listPrimitives()[0]!.setAttribute('POSITION', list);
    await MeshoptEncoder.ready;
    const plain = await read(await glb(scene));
    scene.document.createExtension(EXTMeshoptCompression).setRequired(true);
    const packed = await read(await glb(scene));
    // Half a step is 1.5e-4: three decimals show it best.
    expect(new TextDecoder().decode(plain.file.bytes)).toContain('\n8.000 4.000 2.000\n');
    expect(new TextDecoder().decode(packed.file.bytes)).toContain('format ascii');
    expect(volumeOf(trianglesOf(packed.file))).toBeCloseTo(volumeOf(trianglesOf(plain.file)), 9);
  });
});

describe('Draco', () => {
  it('is decoded, and as coarse as it says', async () => {
    const scene = new Scene();
    scene.add(box(0.8, 0.4, 0.2));
    const compression = scene.document.createExtension(KHRDracoMeshCompression).setRequired(true);
    compression.setEncoderOptions({ quantizationBits: { POSITION: 11 } });
    const { file } = await read(await glb(scene));
    // Half a step of 0.8 in 2047 is 2.0e-4.
    expect(new TextDecoder().decode(file.bytes)).toContain('\n0.800 0.400 0.200\n');
    expect(volumeOf(trianglesOf(file))).toBeCloseTo(0.064, 9);
  });
});

describe('GLB files', () => {
  it('are known by their contents', async () => {
    const scene = new Scene();
    scene.add(box(1, 1, 1));
    const model = await read({ name: 'box.obj', bytes: await scene.glb() });
    expect([model.name, trianglesOf(model.file).corners.length]).toEqual(['box.obj', 36]);
  });

  it('are refused if they are cut off, of another version, or no scene', async () => {
    const scene = new Scene();
    scene.add(box(1, 1, 1));
    const bytes = await scene.glb();
    const sentences = await Promise.all(
      [
        bytes.subarray(0, 10),
        bytes.subarray(0, -9),
        changed(bytes, 4, 1),
        changed(bytes, 20, 0),
      ].map((broken) => refusal([{ name: 'a.glb', bytes: broken }])),
    );
    expect(sentences).toEqual([
      expect.stringContaining("'a.glb' ends before its data does"),
      expect.stringContaining("'a.glb' ends before its data does"),
      expect.stringContaining("'a.glb' is glTF of version 1"),
      expect.stringContaining("'a.glb' has no readable description of its scene"),
    ]);
  });
});
