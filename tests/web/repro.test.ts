import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { checkedRun } from './checked-run.js';
import { isBuilt, runLimit } from './command.js';

const folder = fileURLToPath(new URL('../repro', import.meta.url));
const manifest = 'manifest.txt';

/** Files that once went wrong, and what comes of them now: "nets", or the code of a refusal. */
const cases = readFileSync(join(folder, manifest), 'utf8')
  .split('\n')
  .flatMap((line) => {
    const [, file, outcome] = /^([^#\s]\S*) (\S+): /.exec(line) ?? [];
    return file === undefined || outcome === undefined ? [] : [{ file, outcome }];
  });

it('the manifest lists every file beside it', () => {
  const listed = [...cases.map(({ file }) => file), manifest].sort();
  expect(listed).toEqual(readdirSync(folder).sort());
});

describe.skipIf(!isBuilt)('files that once went wrong', () => {
  it.concurrent.each(cases)(
    '$file',
    async ({ file, outcome }) => {
      const { ended, violations } = await checkedRun(join(folder, file), []);
      expect(ended.status).toBe(outcome === 'nets' ? 0 : 3);
      if (outcome === 'nets') expect(ended.stderr).toBe('');
      else expect(ended.stderr).toMatch(/^[^\n]+: [^\n]+\n$/);
      expect(violations).toEqual([]);
    },
    runLimit + 10_000,
  );
});
