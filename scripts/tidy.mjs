// clang-tidy over the engine: minutes, so not part of the tests.
import { buildEngine } from './make/engine.mjs';
import { sourceFiles } from './files.mjs';
import { setUp } from './setup/index.mjs';
import { root } from './setup/paths.mjs';
import { main, run } from './setup/shell.mjs';

main(() => {
  setUp({ withBrowser: true });
  buildEngine('native', ['foldwright']); // for its compile_commands.json
  run('clang-tidy', ['-p', 'build/native', '--quiet', ...sourceFiles(['cpp'], ['.cpp'])], {
    cwd: root,
  });
});
