/** The package as others get it: packed, and installed into an empty project. */
import { execFile } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync } from 'node:fs';
import { writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { afterAll } from 'vitest';

export const run = promisify(execFile);

export const root = fileURLToPath(new URL('../..', import.meta.url));

let packed: Promise<string> | null = null;

async function pack(): Promise<string> {
  const folder = mkdtempSync(join(tmpdir(), 'foldwright-packed-'));
  const options = ['pack', '--ignore-scripts', '--silent', '--pack-destination', folder];
  const { stdout } = await run('npm', options, { cwd: root });
  return join(folder, stdout.trim());
}

/** The built package as a file, packed once for all tests of a file. */
export function tarball(): Promise<string> {
  return (packed ??= pack());
}

afterAll(async () => {
  if (packed) rmSync(dirname(await packed), { recursive: true });
});

/**
 * Makes an empty project of a folder, with the package and nothing else that it could depend on.
 *
 * @param others packages of this repository that the project has besides, as if it had installed them
 */
export async function install(folder: string, others: readonly string[] = []): Promise<void> {
  const description = { name: 'project', private: true, type: 'module' };
  await writeFile(join(folder, 'package.json'), JSON.stringify(description));
  const options = ['install', '--offline', '--no-audit', '--no-fund', '--no-package-lock'];
  await run('npm', [...options, '--ignore-scripts', await tarball()], { cwd: folder });
  for (const name of others) {
    const place = join(folder, 'node_modules', name);
    mkdirSync(dirname(place), { recursive: true });
    symlinkSync(join(root, 'node_modules', name), place);
  }
}

const tsc = join(root, 'node_modules/typescript/bin/tsc');

const strict = {
  strict: true,
  exactOptionalPropertyTypes: true,
  noUncheckedIndexedAccess: true,
  skipLibCheck: false,
  target: 'ES2022',
  lib: ['ES2022', 'DOM', 'DOM.Iterable'],
  types: [],
};

/** Compiles scripts of a project as strictly as can be; rejects with what the compiler says. */
export async function compile(
  folder: string,
  files: readonly string[],
  options: object,
): Promise<void> {
  const config = { compilerOptions: { ...strict, ...options }, files };
  await writeFile(join(folder, 'tsconfig.json'), JSON.stringify(config));
  await run(process.execPath, [tsc, '-p', folder]).catch((error: { stdout: string }) => {
    throw new Error(error.stdout);
  });
}
