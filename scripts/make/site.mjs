// The documentation site, step by step. What a step makes for the next ones lies below build/site.
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../setup/paths.mjs';
import { run } from '../setup/shell.mjs';
import { contentFingerprint, once } from '../setup/stamp.mjs';

const inRoot = (names) => names.map((name) => join(root, name));

/** Each step runs as a program of its own, since it needs npm's packages. */
const steps = [
  {
    // The pictures show what the built command and package make of the samples.
    name: 'site-pictures',
    inputs: ['site/pictures', 'dist/cli', 'web/app/public/samples', 'scripts/samples'],
    program: ['site/pictures/make.mjs'],
    outputs: ['build/site/pictures', 'build/site/options.json'],
  },
  {
    name: 'site-api',
    inputs: ['web', 'site/api', 'site/typedoc.json', 'package-lock.json'],
    program: ['node_modules/typedoc/bin/typedoc', '--options', 'site/typedoc.json'],
    outputs: ['build/site/api/index.md'],
  },
  {
    name: 'site-demos',
    inputs: ['web', 'site/demos', 'package-lock.json'],
    program: ['site/demos/bundle.mjs'],
    outputs: ['build/site/demos'],
  },
  {
    name: 'site-pages',
    inputs: [
      ...['site', 'build/site', 'docs', 'dist/studio', 'package.json', 'package-lock.json'],
      ...['README.md', 'CHANGELOG.md', 'CONTRIBUTING.md', 'LICENSE', 'web/export'],
    ],
    program: ['node_modules/@11ty/eleventy/cmd.cjs', '--config=site/eleventy.config.js', '--quiet'],
    outputs: ['dist/site/index.html'],
  },
];

/** Makes dist/site of what was built before. */
export function makeSite() {
  for (const { name, inputs, program, outputs } of steps) {
    const make = () => {
      // Pages that are no longer made would stay otherwise.
      if (name === 'site-pages') rmSync(join(root, 'dist/site'), { recursive: true, force: true });
      run(process.execPath, program, { cwd: root });
    };
    once(name, contentFingerprint(inRoot(inputs)), make, inRoot(outputs));
  }
}
