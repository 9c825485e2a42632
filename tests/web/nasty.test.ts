import { readdirSync } from 'node:fs';
import { join, relative } from 'node:path';
import { describe, expect, it } from 'vitest';
import { checkedRun } from './checked-run.js';
import { isBuilt, runLimit, sharedFolder } from './command.js';

const shared = sharedFolder();

function filesBelow(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))
    .sort();
}

const files =
  shared === null
    ? []
    : ['nasty', 'models/academic'].flatMap((name) => filesBelow(join(shared, name)));

describe.skipIf(shared === null || !isBuilt)('files that nobody promised to be models', () => {
  // Hundreds of short programs: most of their time is that of their start.
  it.concurrent.each(files.map((path) => ({ path, name: relative(shared ?? '', path) })))(
    '$name',
    async ({ path }) => {
      const { ended, violations } = await checkedRun(path, ['--compact', 'off']);
      expect([0, 3]).toContain(ended.status);
      if (ended.status === 3) expect(ended.stderr).toMatch(/^[^\n]+: [^\n]+\n$/);
      else expect(ended.stderr).toBe('');
      expect(ended.stdout).toBe('');
      expect(violations).toEqual([]);
    },
    runLimit + 10_000,
  );
});
