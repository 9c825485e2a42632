// All tests of the engine, built as WASM and run under node. `npm test` runs a part of them this way.
import { join } from 'node:path';
import { buildEngine } from './make/engine.mjs';
import { runWasmTests } from './make/wasm-tests.mjs';
import { setUp } from './setup/index.mjs';
import { root } from './setup/paths.mjs';
import { main } from './setup/shell.mjs';

await main(async () => {
  setUp({ withBrowser: true });
  buildEngine('wasm', ['foldwright_tests']);
  const env = { FOLDWRIGHT_SHARED: join(root, '..', 'shared'), ...process.env };
  await runWasmTests('foldwright_tests', env);
});
