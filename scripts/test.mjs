// All tests, in groups; the first group that fails ends the run. The runners' own summaries come last.
import { join } from 'node:path';
import { build } from './make/index.mjs';
import { buildEngine } from './make/engine.mjs';
import { setUp } from './setup/index.mjs';
import { root } from './setup/paths.mjs';
import { main, run } from './setup/shell.mjs';

const env = { FOLDWRIGHT_SHARED: join(root, '..', 'shared'), ...process.env };
const options = { cwd: root, env };
const node = (...args) => run(process.execPath, args, options);

const groups = {
  'set-up and build': () => {
    setUp({ withBrowser: true });
    build();
    // The tests alone: linking the benchmarks as WASM would take longer than running all tests.
    buildEngine('wasm', ['foldwright_tests']);
    buildEngine('native', ['foldwright_tests']);
  },
  lint: () => node('scripts/lint.mjs'),
  'engine as WASM under node': () => node('build/wasm/foldwright_tests.cjs', '--gtest_brief=1'),
  'engine, native': () => run('ctest', ['--preset', 'native'], options),
  'web and browser': () => node('node_modules/vitest/vitest.mjs', 'run'),
};

main(() => {
  for (const [name, group] of Object.entries(groups)) {
    console.log(`\n== ${name}`);
    group();
  }
});
