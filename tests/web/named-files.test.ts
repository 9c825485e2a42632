/** Which files a model names, and where they are found: in memory and on a disk. */
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { placeOnDisk } from '../../web/cli/place-on-disk.js';
import { readModelFiles } from '../../web/cli/read-model-files.js';
import type { ModelFile } from '../../web/model/model-files.js';
import { Companions, placesOf, sourceOf } from '../../web/read/companions.js';
import { companionsOf } from '../../web/read/named-files.js';
import { librariesIn } from '../../web/read/obj-libraries.js';
import { inFolder } from './command.js';
import { encoded, Scene } from './gltf-files.js';
import { read } from './read-model.js';
import { box, objOf } from './solids.js';
import { png } from './tiny-pictures.js';
import { zip } from './zips.js';

const encode = (text: string): Uint8Array => new TextEncoder().encode(text);

/** Names of those beside a model that belong to it. */
function namesBeside(model: ModelFile, ...names: string[]): string[] {
  const files = names.map((name) => ({
    name,
    bytes: name.endsWith('.mtl') ? encode('newmtl a\nmap_Kd tex\\a.png') : png,
  }));
  const companions = new Companions(sourceOf([model, ...files]), model.name);
  return companionsOf(model, (address, base) => companions.find(address, base)).map(
    ({ name }) => name,
  );
}

describe('the libraries of an OBJ file', () => {
  it('are the rest of their lines, each once, wherever they stand', () => {
    const text =
      'mtllib a.mtl\r\nv 0 0 0\n  MTLLIB\t.\\my wood.mtl \nmtllib a.mtl\nmtllibrary x\n# mtllib b\nmtllib c.mtl';
    expect(librariesIn(encode(text))).toEqual(['a.mtl', '.\\my wood.mtl', 'c.mtl']);
    expect(librariesIn(new Uint8Array())).toEqual([]);
    expect(librariesIn(encode(`mtllib ${'x'.repeat(5000)}\nmtllib`))).toEqual([]);
  });
});

describe('files that belong to a model', () => {
  it('are those that it names, and that these name', () => {
    const model = { name: 'm/a.obj', bytes: encode('mtllib a.mtl b.mtl\n') };
    expect(namesBeside(model, 'm/a.mtl', 'm/b.mtl', 'm/tex/A.png', 'm/other.png')).toEqual([
      'm/a.mtl',
      'm/tex/A.png',
      'm/b.mtl',
    ]);
    expect(namesBeside({ name: 'a.obj', bytes: encode('mtllib ../a.mtl') })).toEqual([]);
  });

  it('are buffers and pictures of glTF and GLB files, and pictures of PLY files', async () => {
    const ply = { name: 'a.ply', bytes: encode('ply\ncomment TextureFile a.png\nend_header\n') };
    expect(namesBeside(ply, 'a.png', 'b.png')).toEqual(['a.png']);
    const scene = new Scene();
    scene.add(box(1, 1, 1));
    const { json } = await scene.separate();
    const images = [{ uri: 'my%20wood.png' }, { uri: 'data:image/png;base64,' }];
    const gltf = { name: 'a.gltf', bytes: encoded({ ...json, images }) };
    expect(namesBeside(gltf, 'data.bin', 'my wood.png', 'c.png')).toEqual([
      'data.bin',
      'my wood.png',
    ]);
    expect(namesBeside({ name: 'a.gltf', bytes: encode('{"asset":{"version":"2"}') })).toEqual([]);
  });

  it('are unpacked from an archive, and the others told', async () => {
    const packed = zip('a.zip', {
      'm/a.obj': `mtllib A.mtl\n${objOf(box(1, 1, 1))}`,
      'm/a.mtl': 'newmtl x\nmap_Kd ../tex/a.png',
      'tex/a.png': png,
      'readme.txt': '',
    });
    const model = await read(packed);
    expect(model.companions.map(({ name }) => name)).toEqual(['m/a.mtl', 'tex/a.png']);
    expect(model.notices).toEqual([{ code: 'files-ignored', params: { files: ['readme.txt'] } }]);
  });
});

describe('files on a disk', () => {
  it('are found in whatever case, and not outside the folder', () =>
    inFolder((folder) => {
      mkdirSync(join(folder, 'Tex'));
      writeFileSync(join(folder, 'Tex/Wood.PNG'), 'x');
      writeFileSync(join(folder, 'b.png'), 'x');
      const find = (address: string): string | null =>
        placeOnDisk(folder, placesOf(address, 'a.mtl', 'a.obj'));
      expect(find('tex\\wood.png')).toBe('Tex/Wood.PNG');
      expect(find('C:\\b.png')).toBe('b.png');
      for (const none of ['../b.png/..', 'Tex', 'c.png', '/etc/passwd', '../../etc/passwd']) {
        expect([none, find(none)]).toEqual([none, null]);
      }
      return Promise.resolve();
    }));

  it('come with a model that names them', () =>
    inFolder((folder) => {
      mkdirSync(join(folder, 'tex'));
      writeFileSync(join(folder, 'a.obj'), 'mtllib a.mtl\nv 0 0 0\n');
      writeFileSync(join(folder, 'a.mtl'), 'newmtl x\nmap_Kd tex/a.png\nnewmtl y\nmap_Kd no.png');
      writeFileSync(join(folder, 'tex/a.png'), png);
      writeFileSync(join(folder, 'b.png'), png);
      const names = readModelFiles(join(folder, 'a.obj')).map(({ name }) => name);
      expect(names).toEqual(['a.obj', 'a.mtl', 'tex/a.png']);
      return Promise.resolve();
    }));
});
