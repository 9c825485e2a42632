/** Chromium and node give the same bits for the same file and options. */
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { foldwright, inFolder } from '../web/command.js';
import { objText, wavyRing } from '../web/model-text.js';
import { filesOf, type SavedFile } from './saved-files.js';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();

test('the files and the result hash of the browser are those of the command line', () =>
  inFolder((folder) =>
    withStudio(async (studio) => {
      const text = objText(wavyRing(14));
      await studio.page.fill('#parts', '4');
      await studio.choose('ring.obj', text);
      const hash = await studio.resultOf('ring');
      const formats = { fold: 'FOLD', pdf: 'PDF', dxf: 'Machine (DXF)', png: 'Pictures (PNG)' };
      const files: SavedFile[] = [];
      for (const button of Object.values(formats)) {
        files.push(...filesOf(await studio.download(button)));
      }

      const place = (name: string): string => join(folder, name);
      await writeFile(place('ring.obj'), text);
      const outputs = Object.keys(formats).flatMap((format) => ['-o', place(`ring.${format}`)]);
      const report = place('report.json');
      const args = [place('ring.obj'), '--parts', '4', ...outputs, '--report', report, '--quiet'];
      const { status, stderr } = await foldwright(args);
      expect(`${status} ${stderr}`).toBe('0 ');
      const { result_hash: expected } = JSON.parse(await readFile(report, 'utf8')) as {
        result_hash: string;
      };
      expect(hash).toBe(expected);
      for (const { name, bytes } of files) {
        const same = (await readFile(place(name))).equals(bytes);
        expect([name, same]).toEqual([name, true]);
      }
    }),
  ));
