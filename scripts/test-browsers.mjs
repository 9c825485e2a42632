// The studio in Chromium, Firefox and WebKit: `npm run test:browsers`.
import { build } from './make/index.mjs';
import { setUp } from './setup/index.mjs';
import { root } from './setup/paths.mjs';
import { main, run } from './setup/shell.mjs';

await main(() => {
  setUp({ withBrowser: true, withEngines: true });
  build();
  const vitest = ['node_modules/vitest/vitest.mjs', 'run', '--project', 'engines'];
  run(process.execPath, vitest, { cwd: root });
});
