import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { readProject } from '../../web/project/read-project.js';
import { foldwright, isBuilt, readReport, withModel, type Ended } from './command.js';
import { objText, wavyRing } from './model-text.js';
import { projectErrors } from './project-schema.js';

const ring = objText(wavyRing(10));
const quick = ['--parts', '4', '--runs', '20', '--compact', 'off', '--height', '60', '--quiet'];

/** Runs the command on a file of the folder, without a complaint. */
async function done(folder: string, model: string, ...args: string[]): Promise<Ended> {
  const ended = await foldwright([join(folder, model), ...args]);
  expect(ended).toMatchObject({ status: 0 });
  return ended;
}

/** A folder with a project of a split ring, and the files that were written with it. */
function withProject(
  work: (folder: string, out: (name: string) => string) => Promise<void>,
): Promise<void> {
  return withModel(ring, async (folder) => {
    const out = (name: string): string => join(folder, name);
    const edits = [
      { kind: 'split', part: 1, into: 2 },
      { kind: 'name', part: 2, text: 'Tail' },
    ];
    writeFileSync(out('edits.json'), JSON.stringify(edits));
    const files = ['a.foldwright', 'a.pdf', 'a.fold'].flatMap((name) => ['-o', out(name)]);
    const more = [...files, '--edits', out('edits.json'), '--report', out('a.json')];
    await done(folder, 'model.obj', ...quick, ...more);
    await work(folder, out);
  });
}

describe.skipIf(!isBuilt)('foldwright with a project', () => {
  it('writes one that is valid, and makes the same files of it', () =>
    withProject(async (folder, out) => {
      expect(projectErrors(readFileSync(out('a.foldwright')))).toEqual([]);
      const files = ['b.foldwright', 'b.pdf', 'b.fold'].flatMap((name) => ['-o', out(name)]);
      await done(folder, 'a.foldwright', ...files, '--report', out('b.json'), '--quiet');
      for (const ending of ['foldwright', 'fold', 'pdf']) {
        expect(readFileSync(out(`b.${ending}`)).equals(readFileSync(out(`a.${ending}`)))).toBe(
          true,
        );
      }
      const [a, b] = [readReport(out('a.json')), readReport(out('b.json'))];
      expect(b.result_hash).toBe(a.result_hash);
      expect(b.options['parts']).toBe(4);
    }));

  it('takes options of the command line before those of the project, and edits behind its own', () =>
    withProject(async (folder, out) => {
      const paper = ['--paper', 'A3', '--style', 'blender', '--name', '1=Head'];
      await done(folder, 'a.foldwright', '-o', out('c.foldwright'), ...paper, '--quiet');
      const { project } = readProject({ name: 'c', bytes: readFileSync(out('c.foldwright')) });
      expect(project.steps.map(([edit]) => edit)).toEqual([
        { kind: 'split', part: 1, into: 2 },
        { kind: 'name', part: 2, text: 'Tail' },
        { kind: 'paper', options: { paper: 'A3' } },
        { kind: 'print', options: { style: 'blender' } },
        { kind: 'name', part: 1, text: 'Head' },
      ]);
      await done(folder, 'a.foldwright', '--seed', '9', '--report', out('d.json'), '--quiet');
      const report = readReport(out('d.json'));
      expect(report).toMatchObject({ options: { seed: 9, parts: 4 }, parts: 5 });
    }));

  it('says in one line what is wrong with one', () =>
    withProject(async (folder, out) => {
      const bytes = readFileSync(out('a.foldwright'));
      writeFileSync(out('broken.foldwright'), bytes.subarray(0, 300));
      const broken = await foldwright([out('broken.foldwright'), '-o', out('x.pdf')]);
      expect(broken).toMatchObject({ status: 3, stdout: '' });
      expect(broken.stderr).toMatch(
        /^.*broken\.foldwright: 'broken\.foldwright' is damaged: .*\n$/,
      );
      await done(folder, 'a.foldwright', '--name', '5=Head', '-o', out('c.foldwright'), '--quiet');
      const refused = await foldwright([out('c.foldwright'), '--parts', '2', '--quiet']);
      expect(refused).toMatchObject({ status: 2 });
      expect(refused.stderr).toMatch(
        /^foldwright: edit 3 of the project: there is no part 5: .*\n$/,
      );
      const margin = await foldwright([out('a.foldwright'), '--margin', '200']);
      expect(margin).toMatchObject({ status: 2 });
    }));
});
