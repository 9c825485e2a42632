/** Every engine gives the result and the files of the command line, to the byte. */
import { readFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { expect, test } from 'vitest';
import { filesOf } from '../e2e/saved-files.js';
import { foldwright, inFolder, readReport } from '../web/command.js';
import { engines, useEngines } from './engines-fixture.js';

const withStudio = useEngines();
const formats = ['fold', 'svg', 'pdf'] as const;

/** What the command line makes of the same sample. */
let byCommand: Promise<{ hash: string; files: Map<string, Buffer> }> | null = null;

function runCommand(): Promise<{ hash: string; files: Map<string, Buffer> }> {
  return inFolder(async (folder) => {
    const report = join(folder, 'report.json');
    const outputs = formats.flatMap((format) => ['-o', join(folder, `heart.${format}`)]);
    const model = join('dist', 'studio', 'samples', 'heart.obj');
    const { stderr } = await foldwright([model, ...outputs, '--report', report, '--quiet']);
    expect(stderr).toBe('');
    const { result_hash: hash, files: written } = readReport(report);
    const files = new Map<string, Buffer>();
    for (const path of written) {
      if (path !== report) files.set(basename(path), await readFile(path));
    }
    return { hash, files };
  });
}

test.each(engines)('a sample in $name', (engine) =>
  withStudio(engine, async (studio) => {
    const expected = await (byCommand ??= runCommand());
    await studio.click('.sample', 'Heart');
    expect(await studio.result()).toBe(expected.hash);
    const same: Record<string, boolean> = {};
    for (const format of formats) {
      for (const { name, bytes } of filesOf(await studio.save(format))) {
        same[name] = expected.files.get(name)?.equals(bytes) ?? false;
      }
    }
    expect(same).toEqual(
      Object.fromEntries([...expected.files.keys()].map((name) => [name, true])),
    );
    expect(await studio.complaints()).toEqual([]);
  }),
);
