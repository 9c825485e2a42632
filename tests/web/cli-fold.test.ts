/** FOLD files as models of the command line. */
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { foldwright, inFolder, isBuilt } from './command.js';
import { objText, wavyRing } from './model-text.js';
import { parseFold } from './fold-file.js';

describe.skipIf(!isBuilt)('foldwright with a FOLD file', () => {
  it('unfolds its folded form anew, and says that its nets are left', () =>
    inFolder(async (folder) => {
      const [model, first, second] = ['ring.obj', 'ring.fold', 'again.fold'].map((name) =>
        join(folder, name),
      ) as [string, string, string];
      await writeFile(model, objText(wavyRing(6)));
      expect((await foldwright([model, '--parts', '2', '-o', first])).status).toBe(0);
      const { status, stderr } = await foldwright([first, '--parts', '3', '-o', second]);
      expect(status).toBe(0);
      expect(stderr).toContain('note: the file brings 2 nets of its own, which were not used');
      expect(stderr).toMatch(/ring\.fold: 72 faces, 3 parts, 3 pieces/);
      expect(parseFold(await readFile(second, 'utf8')).nets).toHaveLength(3);
    }));

  it('refuses a crease pattern and a file that is cut off in one sentence', () =>
    inFolder(async (folder) => {
      const file = join(folder, 'bird.fold');
      const pattern = { frame_classes: ['creasePattern'], vertices_coords: [[0, 0]] };
      const text = JSON.stringify(pattern);
      const outcomes = [];
      for (const content of [text, text.slice(0, -4)]) {
        await writeFile(file, content);
        const { status, stderr } = await foldwright([file, '--quiet']);
        outcomes.push([status, stderr.trimEnd().split('\n').length]);
        expect(stderr).toMatch(/only a flat crease pattern|its end is missing/);
      }
      expect(outcomes).toEqual([
        [3, 1],
        [3, 1],
      ]);
    }));
});
