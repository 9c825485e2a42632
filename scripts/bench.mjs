// Builds the benchmarks, native and as WASM, and runs them: `npm run bench [-- --full]`.
import { buildEngine } from './make/engine.mjs';
import { build } from './make/index.mjs';
import { setUp } from './setup/index.mjs';
import { root } from './setup/paths.mjs';
import { main, run } from './setup/shell.mjs';

main(() => {
  setUp({ withBrowser: true });
  build();
  buildEngine('wasm');
  buildEngine('release');
  run(process.execPath, ['tests/bench/run.mjs', ...process.argv.slice(2)], { cwd: root });
});
