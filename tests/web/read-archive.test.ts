import { describe, expect, it } from 'vitest';
import type { ModelFile } from '../../web/model/model-files.js';
import { needsReader } from '../../web/read/format.js';
import { encoded, Scene } from './gltf-files.js';
import { changed, read, refusal, trianglesOf, volumeOf } from './read-model.js';
import { box, objOf } from './solids.js';
import { zip } from './zips.js';

const obj = objOf(box(1, 2, 3));
const text = ({ file }: { file: ModelFile }): string => new TextDecoder().decode(file.bytes);

describe('a ZIP archive', () => {
  it('gives the model in it, under its path, and what was not needed', async () => {
    const model = await read(
      zip('a.zip', {
        'Taxi/car.obj': obj,
        'Taxi/car.mtl': 'newmtl a',
        'Taxi/wood.png': '\x89PNG',
        '__MACOSX/Taxi/._car.obj': 'x',
        'Taxi/.DS_Store': 'x',
        'Taxi/Thumbs.db': 'x',
      }),
    );
    expect([model.name, text(model)]).toEqual(['Taxi/car.obj', obj]);
    const files = ['Taxi/car.mtl', 'Taxi/wood.png'];
    expect(model.notices).toEqual([{ code: 'files-ignored', params: { files } }]);
  });

  it('of several models gives the one that lies least deep, and of these the first by name', async () => {
    const contents = { 'x/a.obj': 'a', 'c.STL': 'c', 'b.obj': obj, 'readme.txt': 'r' };
    const model = await read(zip('a.zip', contents));
    expect([model.name, text(model)]).toEqual(['b.obj', obj]);
    expect(model.notices).toEqual([
      { code: 'archive-choice', params: { file: 'b.obj', others: ['c.STL', 'x/a.obj'] } },
      { code: 'files-ignored', params: { files: ['readme.txt'] } },
    ]);
  });

  it('holds the buffers of its glTF, relative to that and not to its root', async () => {
    const scene = new Scene();
    scene.add(box(1, 2, 3));
    const { json, bin } = await scene.separate();
    const contents = {
      'deep/scene.gltf': encoded(json),
      'deep\\data.bin': bin,
      'data.bin': 'wrong',
    };
    const model = await read(zip('a.zip', contents));
    expect(volumeOf(trianglesOf(model.file))).toBeCloseTo(6);
    expect(model.notices).toEqual([{ code: 'files-ignored', params: { files: ['data.bin'] } }]);
  });

  it('cannot reach out of itself', async () => {
    const scene = new Scene();
    scene.add(box(1, 1, 1));
    const { json, bin } = await scene.separate();
    for (const uri of ['../data.bin', '/data.bin', 'C:\\data.bin', 'http://example.org/data.bin']) {
      const bytes = encoded({ ...json, buffers: [{ ...json.buffers![0], uri }] });
      const contents = { 'a.gltf': bytes, '../data.bin': bin, '/data.bin': bin };
      expect(await refusal([zip('a.zip', contents)])).toMatch(/data.bin, which is missing/);
    }
  });

  it('is refused without a model, and if it is damaged, locked, or unpacks to far too much', async () => {
    expect(await refusal([zip('a.zip', {})])).toBe("there is nothing in the archive 'a.zip'");
    expect(await refusal([zip('a.zip', { 'a.fbx': 'x' })])).toBe(
      "no file in the archive 'a.zip' is a model that is read; it has a.fbx",
    );
    const { bytes } = zip('a.zip', { 'a.obj': obj });
    const broken = (file: Uint8Array): Promise<string> => refusal([{ name: 'a.zip', bytes: file }]);
    expect(await broken(bytes.subarray(0, -30))).toMatch(
      /^the archive 'a.zip' is damaged or cut off/,
    );
    expect(await broken(changed(bytes, 60, bytes[60]! ^ 1))).toMatch(
      /^the archive 'a.zip' is damaged/,
    );
    const list = Buffer.from(bytes).indexOf('PK\x01\x02');
    expect(await broken(changed(bytes, list + 8, 1))).toMatch(/is locked with a password/);
    expect(await broken(changed(bytes, list + 10, 9))).toMatch(/packed in a way that is not read/);
    const zeros = zip('bomb.zip', { 'a.obj': new Uint8Array(40 * 2 ** 20) });
    expect(await refusal([zeros])).toMatch(/hundreds of times its size/);
  });

  it('is refused if more comes out of a file than it says', async () => {
    const { bytes } = zip('a.zip', { 'a.obj': new Uint8Array(2 ** 20) });
    const list = Buffer.from(bytes).indexOf('PK\x01\x02');
    const lying = bytes.slice();
    new DataView(lying.buffer).setUint32(list + 24, 10, true);
    expect(await refusal([{ name: 'a.zip', bytes: lying }])).toMatch(/is damaged/);
  });
});

describe('several files together', () => {
  const box1: ModelFile = { name: 'a.obj', bytes: new TextEncoder().encode(obj) };

  it('are the engine’s where it reads their model', () => {
    expect(needsReader([box1])).toBe(false);
    expect(needsReader([box1, zip('textures.zip', { 'a.png': 'x' })])).toBe(false);
    expect(needsReader([zip('a.zip', {})])).toBe(true);
  });

  it('are refused with two models, or two archives', async () => {
    const scene = new Scene();
    scene.add(box(1, 1, 1));
    const glb = { name: 'b.glb', bytes: await scene.glb() };
    expect(await refusal([glb, box1])).toMatch(/two models among the files: 'b.glb' and 'a.obj'/);
    const archives = ['a.zip', 'b.zip'].map((name) => zip(name, { 'a.obj': obj }));
    expect(await refusal(archives)).toMatch(/two models among the files: 'a.zip' and 'b.zip'/);
  });
});
