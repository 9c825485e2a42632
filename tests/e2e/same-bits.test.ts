/** Chromium and node give the same bits for the same file and options. */
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { foldwright, inFolder } from '../web/command.js';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();

test('the files and the result hash of the browser are those of the command line', () =>
  inFolder((folder) =>
    withStudio(async (studio) => {
      const text = objText(wavyRing(14));
      await studio.page.fill('#parts', '4');
      await studio.choose('ring.obj', text);
      const hash = await studio.resultOf('ring');
      const files = [await studio.download('FOLD'), await studio.download('PDF')];

      const place = (name: string): string => join(folder, name);
      await writeFile(place('ring.obj'), text);
      const outputs = files.flatMap(({ name }) => ['-o', place(name)]);
      const report = place('report.json');
      const args = [place('ring.obj'), '--parts', '4', ...outputs, '--report', report, '--quiet'];
      const { status, stderr } = await foldwright(args);
      expect(`${status} ${stderr}`).toBe('0 ');
      const { result_hash: expected } = JSON.parse(await readFile(report, 'utf8')) as {
        result_hash: string;
      };
      expect(hash).toBe(expected);
      for (const { name, bytes } of files) {
        expect([name, bytes.equals(await readFile(place(name)))]).toEqual([name, true]);
      }
    }),
  ));
