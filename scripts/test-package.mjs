// The package as others take it up: `npm run test:package`.
import { build } from './make/index.mjs';
import { setUp } from './setup/index.mjs';
import { root } from './setup/paths.mjs';
import { main, run } from './setup/shell.mjs';

await main(() => {
  setUp({ withBrowser: true });
  build();
  const vitest = ['node_modules/vitest/vitest.mjs', 'run', '--project', 'package'];
  run(process.execPath, vitest, { cwd: root });
});
