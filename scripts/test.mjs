// All tests, in groups; the first group that fails ends the run. The runners' own summaries come last.
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { build } from './make/index.mjs';
import { buildEngine } from './make/engine.mjs';
import { setUp } from './setup/index.mjs';
import { root } from './setup/paths.mjs';
import { main, run, runTogether } from './setup/shell.mjs';

const env = { FOLDWRIGHT_SHARED: join(root, '..', 'shared'), ...process.env };
const options = { cwd: root, env };
const node = (...args) => run(process.execPath, args, options);

const groups = {
  'set-up and build': () => {
    setUp({ withBrowser: true });
    build();
    // The tests alone: linking the benchmarks as WASM would take longer than running all tests.
    buildEngine('wasm', ['foldwright_tests']);
    buildEngine('native', ['foldwright_tests', 'benchmarks']);
    buildEngine('fuzz', ['fuzzers']);
  },
  lint: () => node('scripts/lint.mjs'),
  'engine as WASM under node': () => {
    // GoogleTest's own way to share tests out: each process has one thread.
    const count = availableParallelism();
    const shard = (_, i) => ({
      cwd: root,
      env: { ...env, GTEST_TOTAL_SHARDS: String(count), GTEST_SHARD_INDEX: String(i) },
    });
    const program = ['build/wasm/foldwright_tests.cjs', '--gtest_brief=1'];
    return runTogether(process.execPath, program, Array.from({ length: count }, shard));
  },
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
