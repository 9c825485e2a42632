// The bundles: the command line, the studio and the package, each built again only when something below web/ changed.
import { join } from 'node:path';
import { root } from '../setup/paths.mjs';
import { run } from '../setup/shell.mjs';
import { contentFingerprint, once } from '../setup/stamp.mjs';

const bundles = [
  { name: 'cli', config: 'web/cli/vite.config.ts', output: 'dist/cli/foldwright.js' },
  { name: 'studio', config: 'web/app/vite.config.ts', output: 'dist/studio/index.html' },
  { name: 'package', config: 'web/element/vite.config.ts', output: 'dist/package/foldwright.js' },
];

/** The gallery's models, which the studio's bundle copies. */
function makeSamples() {
  const script = join(root, 'scripts/make-samples.mjs');
  const inputs = [script, join(root, 'scripts/samples')];
  const output = join(root, 'web/app/public/samples/catalog.json');
  once('samples', contentFingerprint(inputs), () => run(process.execPath, [script]), [output]);
}

/** What it takes to build each sample, by the engine's word; the bundle of the command line must be there. */
function timeSamples() {
  const script = join(root, 'scripts/time-samples.mjs');
  const inputs = [
    script,
    ...['scripts/make-samples.mjs', 'scripts/samples', 'web/core/generated', 'web/model'].map(
      (path) => join(root, path),
    ),
  ];
  once('sample-times', contentFingerprint(inputs), () => run(process.execPath, [script]), [
    join(root, 'dist/cli/index.js'),
  ]);
}

/** Declarations of the package, for those who call it from TypeScript. */
function writeTypes() {
  const tsc = join(root, 'node_modules/typescript/bin/tsc');
  run(process.execPath, [tsc, '-p', 'tsconfig.package.json'], { cwd: root });
}

/** Runs a script of its own, as what uses npm's packages must: this one is loaded before they are installed. */
function runScript(name) {
  run(process.execPath, [join(root, 'scripts', name)]);
}

export function buildWeb() {
  makeSamples();
  const inputs = [
    'web',
    'package.json',
    'package-lock.json',
    'scripts/make',
    'scripts/elements-manifest.mjs',
    'scripts/write-elements.mjs',
    'scripts/write-notices.mjs',
    'tsconfig.json',
    'tsconfig.package.json',
  ];
  const printNow = () => contentFingerprint(inputs.map((name) => join(root, name)));
  const vite = join(root, 'node_modules/vite/bin/vite.js');
  for (const { name, config, output } of bundles) {
    once(
      `bundle-${name}`,
      printNow(),
      () =>
        run(process.execPath, [vite, 'build', '--config', config, '--logLevel', 'warn'], {
          cwd: root,
        }),
      [join(root, output)],
    );
    // The studio's bundle has them in the catalogue of its samples.
    if (name === 'cli') timeSamples();
  }
  const print = printNow();
  once('types', print, writeTypes, [join(root, 'dist/types/api/node.d.ts')]);
  once('elements', print, () => runScript('write-elements.mjs'), [
    join(root, 'dist/custom-elements.json'),
  ]);
  once('notices', print, () => runScript('write-notices.mjs'), [
    join(root, 'dist/THIRD_PARTY_NOTICES'),
  ]);
}
