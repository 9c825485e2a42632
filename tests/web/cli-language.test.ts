/** The command in another language than English: help, faults, remarks, report and sheets. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import type { Report } from '../../web/export/report.js';
import { languages } from '../../web/model/languages.js';
import { foldwright, inFolder, isBuilt, withModel } from './command.js';
import { cube } from './fixtures.js';
import { objText } from './model-text.js';

describe.skipIf(!isBuilt)('the command in German', () => {
  it('helps', async () => {
    const { status, stdout } = await foldwright(['--lang', 'de', '--help']);
    expect(status).toBe(0);
    expect(stdout).toMatch(/^Aufruf: foldwright \[Optionen\] <model>/);
    for (const line of ['Argumente:', 'Optionen:', '(üblich: auto)', 'diese Hilfe zeigen']) {
      expect(stdout).toContain(line);
    }
    expect(stdout).not.toMatch(/\b(the|with|of|default)\b/);
  });

  it('tells, reports and prints', () =>
    withModel(objText(cube), async (folder, model) => {
      const [svg, report] = [join(folder, 'net.svg'), join(folder, 'report.json')];
      const args = [model, '--parts', '1', '--height', '8', '--report', report, '--lang=de'];
      const { stderr } = await foldwright([...args, '-o', svg, '--assembly', 'on']);
      const words = 'die Hälfte der Nähte ist höchstens 8 mm lang und schwer zu kleben';
      expect(stderr).toContain('liest das Modell\n');
      expect(stderr).toContain(`Hinweis: ${words}`);
      expect(stderr).toMatch(/: 12 Flächen, 1 Abschnitt, 1 Teil auf 1 Blatt, 8 x 8 x 8 mm\n$/);
      const { files, notices } = JSON.parse(readFileSync(report, 'utf8')) as Report;
      expect(notices.map(({ text }) => text)).toEqual([expect.stringMatching(`^${words}`)]);
      const printed = files
        .filter((file) => file.endsWith('.svg'))
        .map((file) => readFileSync(file, 'utf8'))
        .join('');
      for (const text of ['diese Seite', 'Blatt 1 von 1', 'Schnittlinie', 'So baust du es']) {
        expect(printed).toContain(`>${text}`);
      }
      expect(printed).not.toMatch(/>(this side|cut|sheet|Finished size)/);
    }));

  it('says what is wrong', () =>
    inFolder(async (folder) => {
      const said = async (...args: string[]): Promise<string> =>
        (await foldwright([...args, '--lang', 'de'])).stderr;
      expect(await said('a.obj', '--paprs', '3')).toBe(
        "foldwright: unbekannte Option '--paprs' (Meinst du --paper oder --parts?)\n",
      );
      expect(await said()).toBe("foldwright: das Argument 'model' fehlt\n");
      const model = join(folder, 'none.obj');
      expect(await said(model)).toBe(`${model}: diese Datei gibt es nicht\n`);
    }));

  it('is refused with the list of languages where there is none of that code', async () => {
    const { status, stderr } = await foldwright(['a.obj', '--lang', 'tlh']);
    expect(status).toBe(2);
    expect(stderr).toBe(`foldwright: option '--lang': 'tlh' is not ${languages.join(' or ')}\n`);
  });
});
