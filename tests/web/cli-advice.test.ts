import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import type { Report } from '../../web/export/report.js';
import { foldwright, inFolder, isBuilt, sharedFolder, withModel } from './command.js';
import { cube } from './fixtures.js';
import { objText } from './model-text.js';

function notesOf(stderr: string): string[] {
  return stderr.split('\n').flatMap((line) => /^note: (.*)$/.exec(line)?.[1] ?? []);
}

const shared = sharedFolder();

describe.skipIf(!isBuilt)('advice of the command line', () => {
  it('is silent on a good result', () =>
    withModel(objText(cube), async (_, model) => {
      const { stderr } = await foldwright([model, '--parts', '1', '--height', '40']);
      expect(notesOf(stderr)).toEqual([]);
    }));

  it('says what stands against printing, and the size that helps', () =>
    withModel(objText(cube), async (folder, model) => {
      const report = join(folder, 'report.json');
      const args = [model, '--parts', '1', '--report', report];
      const { stderr } = await foldwright([...args, '--height', '8']);
      const words =
        'half of the seams are at most 8 mm long, which is hard to glue; easier to build: 20 mm high (--height 20)';
      expect(notesOf(stderr)).toContain(words);
      const { notices, verdict } = JSON.parse(readFileSync(report, 'utf8')) as Report;
      expect(notices.map(({ text }) => text)).toContain(words);
      expect(verdict.map(({ code }) => code)).toContain('short-seams');
      expect(notesOf((await foldwright([...args, '--height', '20'])).stderr)).toEqual([]);
    }));

  it.skipIf(shared === null)(
    'proposes for a koala of 1000 faces what helps',
    () =>
      inFolder(async (folder) => {
        const model = join(shared!, 'models/organic/koala_1000.obj');
        const report = join(folder, 'report.json');
        const run = async (options: string[]): Promise<{ notes: string[]; report: Report }> => {
          const args = [model, '--parts', '8', '--report', report, ...options];
          const { stderr } = await foldwright(args, { limit: 120_000 });
          const written = JSON.parse(readFileSync(report, 'utf8')) as Report;
          return { notes: notesOf(stderr), report: written };
        };
        const { notes } = await run(['--height', '80']);
        const advice = notes.filter((line) => line.startsWith('half of the seams'));
        expect(advice).toHaveLength(1);
        const pattern =
          /at most [67](\.\d)? mm long, .*: (\d+) mm high \(--height \2\), or simplified to (\d+) faces \(--faces \3\)$/;
        const [, , height, faces] = pattern.exec(advice[0]!)!;
        for (const better of [
          ['--height', height!],
          ['--height', '80', '--faces', faces!],
        ]) {
          const { notices } = (await run(better)).report;
          // Other nets have other seams: it may be a little less than promised.
          const short = notices.find(({ code }) => code === 'short-seams');
          expect(short?.params['median_mm'] ?? 12).toBeGreaterThan(11.5);
        }
      }),
    300_000,
  );
});
