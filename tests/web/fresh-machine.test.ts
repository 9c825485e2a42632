/** The commands of the README on a machine where nothing is installed yet. */
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { root } from './packed.js';

type Imports = { file: string; imported: string };

/** What a script loads before its first line runs, and what that loads in turn. */
function imports(file: string, seen = new Set<string>()): Imports[] {
  if (seen.has(file)) return [];
  seen.add(file);
  const text = readFileSync(file, 'utf8');
  const own = [...text.matchAll(/^(?:import|export)\b[^;]*?from '([^']+)'/gm)].map(
    ([, name]) => name!,
  );
  return own.flatMap((name) =>
    name.startsWith('.') ? imports(join(dirname(file), name), seen) : [{ file, imported: name }],
  );
}

const { scripts } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8')) as {
  scripts: Record<string, string>;
};
const entries = Object.entries(scripts).flatMap(([name, command]) => {
  const script = /^node (scripts\S+)/.exec(command)?.[1];
  return script === undefined ? [] : [{ name, script }];
});

describe('scripts that set the machine up', () => {
  it('are found', () => expect(entries.length).toBeGreaterThan(5));

  it.each(entries)('`npm run $name` loads nothing that it has yet to install', ({ script }) => {
    const loaded = imports(join(root, script));
    expect(loaded.length).toBeGreaterThan(0);
    expect(loaded.filter(({ imported }) => !imported.startsWith('node:'))).toEqual([]);
  });
});
