// The npm packages, from the lock file whenever that or package.json has changed.
import { existsSync, mkdirSync, readFileSync, rmSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { root, toolchain } from './paths.mjs';
import { run } from './shell.mjs';
import { fingerprint, once } from './stamp.mjs';

export function npmPackages() {
  const lock = join(root, 'package-lock.json');
  const isLocked = existsSync(lock);
  const files = [join(root, 'package.json'), ...(isLocked ? [lock] : [])];
  once(
    'npm',
    fingerprint(process.version, ...files.map((file) => readFileSync(file))),
    () => {
      run('npm', [isLocked ? 'ci' : 'install', '--no-fund', '--no-audit'], { cwd: root });
      linkTypeScript5();
    },
    [join(root, 'node_modules/.package-lock.json')],
  ); // npm's own record: a removed node_modules is noticed
}

/** Emscripten writes type declarations with the `tsc` on the PATH and knows TypeScript 5 only; ours is newer. */
function linkTypeScript5() {
  const folder = join(toolchain, 'bin');
  mkdirSync(folder, { recursive: true });
  rmSync(join(folder, 'tsc'), { force: true });
  symlinkSync('../../node_modules/typescript-tsd/bin/tsc', join(folder, 'tsc'));
}
