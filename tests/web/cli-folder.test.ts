/** A folder as the model: the files in it belong together. */
import { mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { foldwright, inFolder, isBuilt, type Ended } from './command.js';
import { Scene } from './gltf-files.js';
import { objText, wavyRing } from './model-text.js';
import { box } from './solids.js';
import { zip } from './zips.js';

const ring = objText(wavyRing(6));

/** Fills a folder with files by their paths in it. */
function fill(folder: string, files: Record<string, string>): void {
  for (const [name, content] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), content);
  }
}

const run = (model: string, ...args: string[]): Promise<Ended> =>
  foldwright([model, '--parts', '2', '--runs', '20', ...args]);

describe.skipIf(!isBuilt)('a file that needs others, or holds them', () => {
  it('is read with the buffers beside it, and names those that are missing', () =>
    inFolder(async (folder) => {
      const scene = new Scene();
      scene.add(box(1, 2, 3));
      const { json, bin } = await scene.separate();
      const uri = 'buffers/my%20data.bin';
      const text = JSON.stringify({ ...json, buffers: [{ ...json.buffers![0], uri }] });
      fill(folder, { 'box.gltf': text });
      const model = join(folder, 'box.gltf');
      const missing = `${model}: 'box.gltf' needs buffers/my data.bin, which is missing; choose it as well, or choose the whole folder\n`;
      expect(await run(model, '--quiet')).toEqual({ status: 3, stdout: '', stderr: missing });
      mkdirSync(join(folder, 'buffers'));
      writeFileSync(join(folder, 'buffers/my data.bin'), bin);
      const { status, stderr } = await run(model);
      expect([status, stderr]).toEqual([0, expect.stringContaining('box.gltf: 12 faces')]);
    }));

  it('may be an archive', () =>
    inFolder(async (folder) => {
      const model = join(folder, 'ring.zip');
      writeFileSync(model, zip('ring.zip', { 'a/ring.obj': ring, 'b/ring.obj': ring }).bytes);
      const { status, stderr } = await run(model);
      expect([status, stderr]).toEqual([0, expect.stringContaining(`${model}: 72 faces`)]);
      expect(stderr).toContain(
        "the archive has 2 models; 'a/ring.obj' was taken, and not b/ring.obj",
      );
    }));

  it('of a format that is not read is refused with what to do', () =>
    inFolder(async (folder) => {
      fill(folder, { 'a.fbx': 'Kaydara FBX Binary  ', 'b.dae': '<COLLADA' });
      for (const [name, format] of [
        ['a.fbx', 'an FBX model'],
        ['b.dae', 'a COLLADA (DAE) model'],
      ] as const) {
        const { status, stderr } = await run(join(folder, name), '--quiet');
        expect([status, stderr]).toEqual([
          3,
          expect.stringContaining(`${format}, which is not read`),
        ]);
        expect(stderr).toContain('save it as GLB, OBJ,');
      }
    }));
});

describe.skipIf(!isBuilt)('a folder as the model', () => {
  it('gives what its model alone gives, and tells what was not needed', () =>
    inFolder(async (folder) => {
      const [model, outputs] = [join(folder, 'ring'), join(folder, 'out')];
      mkdirSync(outputs);
      fill(model, {
        'obj/ring.obj': ring,
        'obj/ring.mtl': 'newmtl wood\n',
        'textures/wood.png': '\x89PNG',
        '.DS_Store': 'x',
      });
      symlinkSync(folder, join(model, 'loop'));
      const [one, other] = [join(outputs, 'a.fold'), join(outputs, 'b.fold')];
      const { status, stderr } = await run(model, '-o', one);
      expect([status, stderr]).toEqual([0, expect.stringContaining(`${model}: `)]);
      const note = 'note: 2 other files were not needed: obj/ring.mtl and textures/wood.png\n';
      expect(stderr).toContain(note);
      expect((await run(join(model, 'obj/ring.obj'), '-o', other)).stderr).not.toContain('needed');
      expect(readFileSync(one, 'utf8')).toBe(readFileSync(other, 'utf8'));
    }));

  it('is refused with two models, which are named', () =>
    inFolder(async (folder) => {
      fill(folder, { 'a.obj': ring, 'b.txt': ring, 'c.mtl': 'newmtl wood\n' });
      const text = `${folder}: there are two models among the files: 'a.obj' and 'b.txt'; choose one of them\n`;
      expect(await run(folder, '--quiet')).toEqual({ status: 3, stdout: '', stderr: text });
    }));

  it('is refused without a model, and with far too many files', () =>
    inFolder(async (folder) => {
      fill(folder, { 'a.mtl': 'newmtl wood\n', 'b.png': '\x89PNG' });
      const { status, stderr } = await run(folder, '--quiet');
      expect([status, stderr]).toEqual([3, expect.stringContaining('none of the 2 files')]);
      for (let i = 0; i < 1000; ++i) writeFileSync(join(folder, `${i}.txt`), '');
      const many = `${folder}: the folder has more than 1000 files\n`;
      expect((await run(folder, '--quiet')).stderr).toBe(many);
    }));
});
