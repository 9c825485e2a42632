// The bundles: the command line and the studio, each built again only when something below web/ changed.
import { join } from 'node:path';
import { root } from '../setup/paths.mjs';
import { run } from '../setup/shell.mjs';
import { contentFingerprint, once } from '../setup/stamp.mjs';
import { writeNotices } from './notices.mjs';

const bundles = [
  { name: 'cli', config: 'web/cli/vite.config.ts', output: 'dist/cli/foldwright.js' },
  { name: 'studio', config: 'web/app/vite.config.ts', output: 'dist/studio/index.html' },
];

/** The gallery's models, which the studio's bundle copies. */
function makeSamples() {
  const script = join(root, 'scripts/make-samples.mjs');
  const inputs = [script, join(root, 'scripts/samples')];
  const output = join(root, 'web/app/public/samples/catalog.json');
  once('samples', contentFingerprint(inputs), () => run(process.execPath, [script]), [output]);
}

/** Declarations of the package, for those who call it from TypeScript. */
function writeTypes() {
  const tsc = join(root, 'node_modules/typescript/bin/tsc');
  run(process.execPath, [tsc, '-p', 'tsconfig.package.json'], { cwd: root });
}

export function buildWeb() {
  makeSamples();
  const inputs = [
    'web',
    'package-lock.json',
    'scripts/make',
    'tsconfig.json',
    'tsconfig.package.json',
  ];
  const print = contentFingerprint(inputs.map((name) => join(root, name)));
  const vite = join(root, 'node_modules/vite/bin/vite.js');
  for (const { name, config, output } of bundles) {
    once(
      `bundle-${name}`,
      print,
      () =>
        run(process.execPath, [vite, 'build', '--config', config, '--logLevel', 'warn'], {
          cwd: root,
        }),
      [join(root, output)],
    );
  }
  once('types', print, writeTypes, [join(root, 'dist/types/api/node.d.ts')]);
  once('notices', print, writeNotices, [join(root, 'dist/THIRD_PARTY_NOTICES')]);
}
