/** The packed package by the checkers of others. */
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { root, run, tarball } from '../web/packed.js';

/** What a checker says; rejects if it finds a fault. */
async function checked(script: string, ...args: string[]): Promise<string> {
  const { stdout } = await run(process.execPath, [join(root, 'node_modules', script), ...args]);
  return stdout;
}

test('publint finds nothing', async () => {
  const said = await checked('publint/src/cli.js', 'run', await tarball(), '--strict');
  expect(said).toContain('All good');
});

test('all entries have their types however they are resolved', async () => {
  // The package is ESM alone; its status says whether that is typed.
  const options = ['--profile', 'esm-only', '--no-color', '--no-emoji'];
  const said = await checked('@arethetypeswrong/cli/dist/index.js', await tarball(), ...options);
  for (const name of ['', '/viewer', '/studio', '/jsx/react', '/jsx/preact', '/jsx/solid']) {
    expect(said).toContain(`foldwright${name}`);
  }
});

test('the licences of others are in it', async () => {
  const { stdout } = await run('tar', ['-tzf', await tarball()]);
  const files = stdout.split('\n');
  for (const name of ['LICENSE', 'CHANGELOG.md', 'dist/THIRD_PARTY_NOTICES']) {
    expect(files).toContain(`package/${name}`);
  }
});
