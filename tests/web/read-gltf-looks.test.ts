/** Materials, pictures and colours of glTF files, as their reader hands them over. */
import type { GLTF, Material, Node } from '@gltf-transform/core';
import { KHRTextureTransform } from '@gltf-transform/extensions';
import { describe, expect, it } from 'vitest';
import type { ModelFile } from '../../web/model/model-files.js';
import { encoded, Scene } from './gltf-files.js';
import type { LookedTriangles } from './ply-file.js';
import { codesOf, read, trianglesOf } from './read-model.js';
import { beginnings, png } from './tiny-pictures.js';

const triangle = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], corners: [0, 1, 2] };

/** A triangle of that material, with places in pictures: right and down. */
function addTriangle(scene: Scene, material: Material, places: Record<string, number[]>): Node {
  const node = scene.add(triangle);
  const primitive = node.getMesh()!.listPrimitives()[0]!.setMaterial(material);
  for (const [name, values] of Object.entries(places)) {
    primitive.setAttribute(name, scene.list('VEC2', new Float32Array(values)));
  }
  return node;
}

function withPicture(scene: Scene, bytes: Uint8Array = png): Material {
  const texture = scene.document.createTexture('wood').setImage(bytes).setMimeType('image/png');
  return scene.document.createMaterial('planks').setBaseColorTexture(texture);
}

async function looked(scene: Scene): Promise<LookedTriangles> {
  return trianglesOf((await read({ name: 'a.glb', bytes: await scene.glb() })).file);
}

const rounded = (values: readonly number[]): number[] =>
  values.map((value) => Number(value.toFixed(4)));

/** JSON and buffer of a textured triangle, with another first picture. */
async function separate(image: GLTF.IImage): Promise<ModelFile[]> {
  const scene = new Scene();
  addTriangle(scene, withPicture(scene), { TEXCOORD_0: [0, 0, 1, 0, 0, 1] });
  const { json, bin } = await scene.separate();
  return [
    { name: 'a.gltf', bytes: encoded({ ...json, images: [image] }) },
    { name: 'data.bin', bytes: bin },
  ];
}

describe('materials of glTF', () => {
  it('have colours as screens show them', async () => {
    const scene = new Scene();
    const red = scene.document.createMaterial('red').setBaseColorFactor([0.5, 0.0021, 0, 1]);
    addTriangle(scene, red, {});
    scene.add(triangle);
    addTriangle(scene, scene.document.createMaterial(), {});
    const model = await read({ name: 'a.glb', bytes: await scene.glb() });
    expect(model.looks?.materials.map(({ name, colour }) => [name, colour])).toEqual([
      ['red', [188, 7, 0]],
      ['material 2', [255, 255, 255]],
    ]);
    const { materials, places, colours } = trianglesOf(model.file);
    expect([materials, places, colours]).toEqual([[0, -1, 1], [], []]);
  });

  it('have pictures, each once, and say what these do beyond their edges', async () => {
    const scene = new Scene();
    const material = withPicture(scene);
    material.getBaseColorTextureInfo()!.setWrapS(33071).setWrapT(33648);
    addTriangle(scene, material, { TEXCOORD_0: [0, 0, 1, 0.25, 0, 1] });
    addTriangle(scene, material.clone().setBaseColorFactor([0, 1, 0, 1]), {});
    const model = await read({ name: 'a.glb', bytes: await scene.glb() });
    const { materials, pictures } = model.looks!;
    expect(pictures).toEqual([{ name: 'wood', bytes: png }]);
    expect(materials.map(({ picture, wrap }) => [picture, wrap])).toEqual([
      [0, ['clamp', 'mirror']],
      [0, ['clamp', 'mirror']],
    ]);
    const { places } = trianglesOf(model.file);
    expect(places).toEqual([0, 1, 1, 0.75, 0, 0, NaN, NaN, NaN, NaN, NaN, NaN]);
    expect(model.notices).toEqual([]);
  });

  it('say which set of places counts, and how these are moved', async () => {
    const scene = new Scene();
    const material = withPicture(scene);
    const moved = scene.document.createExtension(KHRTextureTransform).createTransform();
    moved
      .setTexCoord(1)
      .setOffset([0.5, 0.25])
      .setRotation(Math.PI / 2)
      .setScale([2, 3]);
    material.getBaseColorTextureInfo()!.setExtension('KHR_texture_transform', moved);
    const sets = { TEXCOORD_0: [9, 9, 9, 9, 9, 9], TEXCOORD_1: [0, 0, 1, 0, 0, 1] };
    addTriangle(scene, material, sets);
    // Turned counter-clockwise: right becomes up, and down becomes right.
    expect(rounded((await looked(scene)).places)).toEqual([0.5, 0.75, 0.5, 2.75, 3.5, 0.75]);
    material.getBaseColorTextureInfo()!.setExtension('KHR_texture_transform', null).setTexCoord(1);
    const model = await read({ name: 'a.glb', bytes: await scene.glb() });
    expect(rounded(trianglesOf(model.file).places)).toEqual([0, 1, 1, 1, 0, 0]);
    expect(model.notices).toEqual([]);
    material.getBaseColorTextureInfo()!.setTexCoord(0);
    expect(codesOf(await read({ name: 'a.glb', bytes: await scene.glb() }))).toEqual([
      'unused-content',
    ]);
  });

  it('may be of the kind that came before', async () => {
    const scene = new Scene();
    addTriangle(scene, withPicture(scene), { TEXCOORD_0: [0, 0, 1, 0, 0, 1] });
    const { json, bin } = await scene.separate();
    const extensions = {
      KHR_materials_pbrSpecularGlossiness: {
        diffuseFactor: [0, 1, 0, 1],
        diffuseTexture: { index: 0 },
      },
    };
    const model = await read(
      {
        name: 'a.gltf',
        bytes: encoded({ ...json, images: [{ uri: 'a.png' }], materials: [{ extensions }] }),
      },
      { name: 'data.bin', bytes: bin },
      { name: 'a.png', bytes: png },
    );
    expect(model.looks?.materials).toMatchObject([{ colour: [0, 255, 0], picture: 0 }]);
  });
});

describe('colours at the corners of glTF', () => {
  it('are shares of light, as floats or whole numbers; meshes without are white', async () => {
    const scene = new Scene();
    const [node, other] = [scene.add(triangle), scene.add(triangle)];
    scene.add(triangle);
    const light = new Float32Array([0, 0.5, 1, 0, 0, 0, 2, -1, 1]);
    node.getMesh()!.listPrimitives()[0]!.setAttribute('COLOR_0', scene.list('VEC3', light));
    const bytes = new Uint8Array([255, 0, 128, 9, 0, 0, 0, 9, 0, 255, 0, 9]);
    const list = scene.list('VEC4', bytes).setNormalized(true);
    other.getMesh()!.listPrimitives()[0]!.setAttribute('COLOR_0', list);
    expect((await looked(scene)).colours).toEqual([
      ...[0, 188, 255, 0, 0, 0, 255, 0, 255],
      ...[255, 0, 188, 0, 0, 0, 0, 255, 0],
      ...new Array<number>(9).fill(255),
    ]);
  });
});

describe('pictures of a glTF file', () => {
  it('lie beside it, or in its addresses', async () => {
    const files = await separate({ uri: 'textures/my%20wood.png' });
    const beside = await read(...files, { name: 'textures/my wood.png', bytes: png });
    expect(beside.looks?.pictures).toEqual([{ name: 'textures/my wood.png', bytes: png }]);
    expect(beside.notices).toEqual([]);
    const uri = `data:image/png;base64,${Buffer.from(png).toString('base64')}`;
    const inside = await read(...(await separate({ uri })));
    expect(inside.looks?.pictures).toEqual([{ name: 'picture 1', bytes: png }]);
  });

  it('are named where they are missing or of another kind', async () => {
    const missing = await read(...(await separate({ uri: 'my%20wood.png' })));
    const what = { what: 'pictures', files: ['my wood.png'] };
    expect(missing.notices).toEqual([{ code: 'missing-looks', params: what }]);
    expect(missing.looks?.materials).toMatchObject([{ picture: null }]);
    const scene = new Scene();
    addTriangle(scene, withPicture(scene, beginnings['KTX']), { TEXCOORD_0: [0, 0, 1, 0, 0, 1] });
    const other = await read({ name: 'a.glb', bytes: await scene.glb() });
    expect(other.notices).toEqual([
      { code: 'unread-pictures', params: { files: ['wood'], kinds: ['KTX'] } },
    ]);
  });

  it('do no harm where they lead nowhere', async () => {
    for (const image of [
      { bufferView: 99 },
      {},
      { uri: 'http://example.org/a.png' },
      { uri: '../a.png' },
    ]) {
      const model = await read(...(await separate(image)));
      expect(model.looks?.materials).toMatchObject([{ picture: null }]);
      expect(model.notices).toHaveLength(1);
      expect(trianglesOf(model.file).corners).toHaveLength(3);
    }
  });
});

describe('damaged looks of a glTF file', () => {
  it('leave its shape to be read', async () => {
    const scene = new Scene();
    const node = addTriangle(scene, withPicture(scene), { TEXCOORD_0: [0, 0, 1, 0, 0, 1] });
    const { json, bin } = await scene.separate();
    const place = json.meshes![0]!.primitives[0]!.attributes['TEXCOORD_0']!;
    for (const broken of [{ count: 2 }, { bufferView: 99 }, { count: 1e9 }]) {
      const accessors = json.accessors!.map((accessor, i) =>
        i === place ? { ...accessor, ...broken } : accessor,
      );
      const model = await read(
        { name: 'a.gltf', bytes: encoded({ ...json, accessors, images: [{ uri: 'a.png' }] }) },
        { name: 'data.bin', bytes: bin },
        { name: 'a.png', bytes: png },
      );
      expect(codesOf(model)).toContain('damaged-looks');
      expect(model.looks).toBeNull();
      expect(trianglesOf(model.file)).toMatchObject({ corners: [0, 1, 2], places: [] });
    }
    expect(node.getMesh()).not.toBeNull();
  });
});
