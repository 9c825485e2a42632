/** The hashes that hosts let browsers check the build's files by. */
import { createHash } from 'node:crypto';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { isBuilt } from './command.js';
import { root } from './packed.js';

describe.skipIf(!isBuilt).each(['studio', 'package'])('integrity.json of dist/%s', (name) => {
  const folder = join(root, 'dist', name);

  it('has the hash of every file', async () => {
    const { integrity } = JSON.parse(await readFile(join(folder, 'integrity.json'), 'utf8')) as {
      integrity: Record<string, string>;
    };
    const entries = await readdir(folder, { recursive: true, withFileTypes: true });
    const files = entries.filter((entry) => entry.isFile() && entry.name !== 'integrity.json');
    expect(Object.keys(integrity)).toHaveLength(files.length);
    for (const [path, told] of Object.entries(integrity)) {
      const hash = createHash('sha384').update(await readFile(join(folder, path)));
      expect(`sha384-${hash.digest('base64')}`, path).toBe(told);
    }
  });
});
