/** Every example for a shell does what it says: those of a page one after the other, in one folder. */
import { existsSync } from 'node:fs';
import { rm } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { inFolder } from '../web/command.js';
import { run } from '../web/packed.js';
import { examplesOf } from './examples.js';
import { fillShop, shopEnvironment } from './shop.js';

const examples = examplesOf('sh');
const byPage = [...new Set(examples.map(({ source }) => source))].map(
  (page) => [page, examples.filter(({ source }) => source === page)] as const,
);

async function shell(folder: string, code: string, more: NodeJS.ProcessEnv = {}): Promise<string> {
  const env = { ...shopEnvironment(folder), ...more };
  const { stdout } = await run('sh', ['-euc', code], { cwd: folder, env });
  return stdout;
}

/** Files and folders that an example says it makes, and has not; several sheets are several files. */
function missingOutputs(folder: string, code: string): string[] {
  const named = [...code.matchAll(/\s(?:-o|--report|--out) (\S+)/g)].map(([, name]) => name!);
  const first = (name: string): string => name.replace(/(\.\w+)$/, '-1$1');
  return named.filter(
    (name) => ![name, first(name)].some((path) => existsSync(join(folder, path))),
  );
}

describe.each(byPage)('examples of %s', (_, ofPage) => {
  test(ofPage.map(({ line, code }) => `line ${line}: ${code.split('\n')[0]}`).join('; '), () =>
    inFolder(async (folder) => {
      await fillShop(folder);
      for (const { name, code } of ofPage) {
        await expect(shell(folder, code), name).resolves.toBeTypeOf('string');
        expect(missingOutputs(folder, code), name).toEqual([]);
      }
    }),
  );
});

/** The command line of a container, as YAML folds it (`>-`). */
function foldedCommand(yaml: string): string {
  const lines = yaml.split('\n');
  const first = lines.findIndex((line) => line.trim() === '- >-') + 1;
  const indent = /^ */.exec(lines[first]!)![0];
  const last = lines.findIndex((line, i) => i > first && !line.startsWith(indent));
  return lines
    .slice(first, last)
    .map((line) => line.trim())
    .join(' ');
}

test.each(examplesOf('yaml'))('the command line in $name', ({ code }) =>
  inFolder(async (folder) => {
    await fillShop(folder);
    const command = foldedCommand(code).replaceAll('/catalogue', folder);
    await shell(folder, command, { JOB_COMPLETION_INDEX: '0' });
    await rm(join(folder, 'nets'), { recursive: true });
  }),
);
