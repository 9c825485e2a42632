import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { foldwright, isBuilt, readReport, withModel } from './command.js';
import { cube } from './fixtures.js';
import { checkFold } from './fold-check.js';
import { parseFold } from './fold-file.js';
import { objText, wavyRing } from './model-text.js';
import { schemaErrors } from './report-schema.js';

describe.skipIf(!isBuilt)('edits on the command line', () => {
  it('split and merge parts of what comes out', () =>
    withModel(objText(wavyRing(12)), async (folder, model) => {
      const [fold, path] = [join(folder, 'out.fold'), join(folder, 'report.json')];
      const outputs = ['-o', fold, '--report', path, '--quiet'];
      const args = [model, '--parts', '2', '--compact', 'off', ...outputs];
      expect((await foldwright([...args, '--split', '2:3'])).status).toBe(0);
      const report = readReport(path);
      expect(schemaErrors(report)).toEqual([]);
      expect(report).toMatchObject({ parts: 4, options: { split: ['2:3'], merge: [] } });
      expect(checkFold(parseFold(readFileSync(fold, 'utf8')))).toEqual([]);
      expect((await foldwright([...args, '--merge', '1,2'])).status).toBe(0);
      expect(readReport(path)).toMatchObject({ parts: 1, options: { split: [], merge: ['1,2'] } });
    }));

  it('name parts, after all other changes', () =>
    withModel(objText(wavyRing(12)), async (folder, model) => {
      const [svg, path] = [join(folder, 'out.svg'), join(folder, 'report.json')];
      const args = [model, '--parts', '2', '--compact', 'off', '--split', '1', '--report', path];
      const names = ['--name', '3=Crest', '--name', '1=a=b', '-o', svg, '--quiet'];
      expect(await foldwright([...args, ...names])).toEqual({ status: 0, stdout: '', stderr: '' });
      const report = readReport(path);
      expect(schemaErrors(report)).toEqual([]);
      expect(report).toMatchObject({ parts: 3, options: { name: ['3=Crest', '1=a=b'] } });
      const named = (report.pieces as { name: string; part: number }[]).map(
        ({ name, part }) => `${part} ${name}`,
      );
      expect(named).toContain('3 Crest');
      expect(named).toContain('1 a=b');
    }));

  it.each([
    ['9=x', "the name 'x': there is no part 9: the model has 2"],
    ['1=a:b', "the name 'a:b': the name of a part must not hold a colon"],
    ['1=12', "the name '12': the name of a part must not be a number"],
  ])('are refused in one sentence for the name %s', (name, sentence) =>
    withModel(objText(wavyRing(8)), async (folder, model) => {
      const out = ['-o', join(folder, 'out.svg')];
      const ended = await foldwright([model, '--parts', '2', '--quiet', ...out, '--name', name]);
      expect(ended.status).toBe(2);
      expect(ended.stderr).toContain(sentence);
      expect(readdirSync(folder)).toEqual(['model.obj']);
    }),
  );

  it('of a file are made one after the other', () =>
    withModel(objText(wavyRing(12)), async (folder, model) => {
      const [fold, path] = [join(folder, 'out.fold'), join(folder, 'report.json')];
      const edits = join(folder, 'edits.json');
      const list = [
        { kind: 'split', part: 2, into: 2 },
        { kind: 'name', part: 3, text: 'Crest' },
        { kind: 'paper', options: { paper: 'A3', 'flap-side': 'both' } },
        { kind: 'print', options: { style: 'pepakura' } },
      ];
      writeFileSync(edits, JSON.stringify(list));
      const outputs = ['-o', fold, '-o', join(folder, 'out.svg'), '--report', path, '--quiet'];
      const args = [model, '--parts', '2', '--compact', 'off', '--edits', edits, ...outputs];
      expect(await foldwright(args)).toEqual({ status: 0, stdout: '', stderr: '' });
      expect(readReport(path)).toMatchObject({ parts: 3, options: { edits } });
      expect(checkFold(parseFold(readFileSync(fold, 'utf8')))).toEqual([]);
      const svg = readFileSync(
        join(
          folder,
          readdirSync(folder).find((name) => /svg$/.test(name))!,
        ),
      );
      expect(svg.toString()).toMatch(/297mm[^]*Crest/);
    }));

  it.each([
    ['[', "edits.json' is no JSON"],
    ['{}', "edits.json': the edits are no list"],
    ['[{"kind":"fold"}]', "edits.json': edit 1 has the kind 'fold', which is none of split, merge"],
    ['[{"kind":"split","part":0,"into":2}]', "(split): 'part' is not a whole number from 1 on"],
    ['[{"kind":"cut","edge":[1,2],"part":1}]', "(cut): there is no 'part'"],
    [
      '[{"kind":"name","part":1,"text":"A1"},{"kind":"cut","edge":[0,0]}]',
      'edit 2: the model has no edge between corners 0 and 0',
    ],
    ['[{"kind":"paper","options":{"parts":3}}]', "option 'parts' cannot be changed here"],
  ])('are refused in one sentence for %s', (content, sentence) =>
    withModel(objText(cube), async (folder, model) => {
      const edits = join(folder, 'edits.json');
      writeFileSync(edits, content);
      const { status, stderr } = await foldwright([model, '--edits', edits, '--quiet']);
      expect(stderr).toContain(sentence);
      expect(stderr.trim().split('\n')).toHaveLength(1);
      expect(status).toBe(2);
    }),
  );

  it('say in one sentence which parts cannot be split', () =>
    withModel(objText(cube), async (folder, model) => {
      const args = [model, '--parts', '2', '--split', '3', '-o', join(folder, 'out.svg')];
      expect(await foldwright([...args, '--quiet'])).toEqual({
        status: 2,
        stdout: '',
        stderr: 'foldwright: there is no part 3: the model has 2 parts\n',
      });
      expect(readdirSync(folder)).toEqual(['model.obj']);
    }));
});
