/** A folder as the model: the files in it belong together. */
import { mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { foldwright, inFolder, isBuilt, type Ended } from './command.js';
import { objText, wavyRing } from './model-text.js';

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
