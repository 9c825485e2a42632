// All tests, in groups; the first group that fails ends the run. The runners' own summaries come last.
import { join } from 'node:path';
import { build } from './make/index.mjs';
import { buildEngine } from './make/engine.mjs';
import { setUp } from './setup/index.mjs';
import { root } from './setup/paths.mjs';
import { main, run } from './setup/shell.mjs';
import { runWasmTests } from './make/wasm-tests.mjs';

const env = { FOLDWRIGHT_SHARED: join(root, '..', 'shared'), ...process.env };
const options = { cwd: root, env };
const node = (...args) => run(process.execPath, args, options);

const groups = {
  'set-up and build': () => {
    setUp({ withBrowser: true });
    build();
    // `npm run test:wasm` builds and runs all tests as WASM.
    buildEngine('wasm', ['foldwright_core_tests']);
    buildEngine('native', ['foldwright_tests', 'benchmarks']);
    buildEngine('fuzz', ['fuzzers']);
  },
  lint: () => node('scripts/lint.mjs'),
  'engine as WASM under node': () => runWasmTests('foldwright_core_tests', env),
  'engine, native': () => run('ctest', ['--preset', 'native'], options),
  'engine under a fuzzer, for a short run': () => run('ctest', ['--preset', 'fuzz'], options),
  // The other projects are `npm run test:browsers` and `npm run test:package`.
  'web and browser': () =>
    node('node_modules/vitest/vitest.mjs', 'run', '--project', 'web', '--project', 'browser'),
};

await main(async () => {
  for (const [name, group] of Object.entries(groups)) {
    // Since the process began: what slows the whole down shall be seen.
    console.log(`\n== ${name}, after ${process.uptime().toFixed(0)} s`);
    await group();
  }
});
