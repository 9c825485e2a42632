/** A folder as the examples expect it: models, the built files, and the commands under their names. */
import { cp, mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { root } from '../web/packed.js';

const command = join(root, 'dist/cli/foldwright.js');
const samples = join(root, 'dist/studio/samples');

/** Stand-ins for programs; `$0` of each is a file in `bin`. */
const programs = {
  foldwright: `exec ${process.execPath} ${command} "$@"`,
  // `npm run -s foldwright -- ..` is run; of other scripts it is enough that there are such: they build and test everything.
  npm: `if [ "$1 $2 $3 $4" = "run -s foldwright --" ]; then shift 4; exec foldwright "$@"; fi
    if [ "$1" = run ]; then shift; fi
    exec ${process.execPath} -e 'process.exit(process.argv[1] in require("${root}/package.json").scripts ? 0 : 1)' "$1"`,
  npx: 'exec "$@"',
  // What a cluster's program adds is where a task runs; here it runs at once.
  srun: 'exec "$@"',
  // Once for each value behind `:::`, which takes the place of `{}`.
  parallel: `for word in "$@"; do case "$word" in *' '*) line=$word;; esac; done
    while [ "$1" != ::: ]; do shift; done
    shift
    for value in "$@"; do sh -ec "$(printf %s "$line" | sed "s/{}/$value/g")" || exit; done`,
};

/** Models of few faces, under the names that examples use, and the materials that they name. */
const models = {
  'house.obj': 'house.obj',
  'house.mtl': 'house.mtl',
  'animals/whale.obj': 'cube.obj',
  'animals/cube.mtl': 'cube.mtl',
};

async function addPrograms(folder: string): Promise<void> {
  await mkdir(join(folder, 'bin'));
  for (const [name, script] of Object.entries(programs)) {
    await writeFile(join(folder, 'bin', name), `#!/bin/sh\n${script}\n`, { mode: 0o755 });
  }
}

/** Fills an empty folder for examples of the shell. */
export async function fillShop(folder: string): Promise<void> {
  await addPrograms(folder);
  await cp(samples, join(folder, 'dist/studio/samples'), { recursive: true });
  for (const [name, sample] of Object.entries(models)) {
    await cp(join(samples, sample), join(folder, 'models', name));
  }
}

/** Where the examples' programs are found before any others. */
export function shopEnvironment(folder: string): NodeJS.ProcessEnv {
  return {
    ...process.env,
    PATH: `${join(folder, 'bin')}:${process.env['PATH']}`,
    SLURM_ARRAY_TASK_ID: '1',
  };
}
