// The documentation site: its links, its examples and its demonstrations: `npm run test:site`.
import { build } from './make/index.mjs';
import { makeSite } from './make/site.mjs';
import { setUp } from './setup/index.mjs';
import { root } from './setup/paths.mjs';
import { main, run } from './setup/shell.mjs';

await main(() => {
  setUp({ withBrowser: true });
  build();
  makeSite();
  run(process.execPath, ['node_modules/vitest/vitest.mjs', 'run', '--project', 'site'], {
    cwd: root,
  });
});
