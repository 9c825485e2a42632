// Formatters, linters, layers and types; with --fix the formatters write instead of complaining.
import { join } from 'node:path';
import { sourceFiles } from './files.mjs';
import { root } from './setup/paths.mjs';
import { main, run } from './setup/shell.mjs';

const fix = process.argv.includes('--fix');
const module = (path, ...args) => run(process.execPath, [join(root, path), ...args], { cwd: root });

main(() => {
  const cpp = sourceFiles(['cpp', 'bindings', 'tests'], ['.h', '.cpp']);
  run('clang-format', [...(fix ? ['-i'] : ['--dry-run', '-Werror']), ...cpp], { cwd: root });
  module(
    'node_modules/prettier/bin/prettier.cjs',
    fix ? '--write' : '--check',
    '.',
    '--log-level=warn',
  );
  module('node_modules/eslint/bin/eslint.js', '.', ...(fix ? ['--fix'] : []));
  module('scripts/check-layers.mjs');
  module('scripts/check-prose.mjs');
  module('scripts/check-words.mjs');
  module('scripts/check-addresses.mjs');
  module('scripts/check-elements.mjs', ...(fix ? ['--fix'] : []));
  // Other globals exist in a service worker than in a page.
  for (const project of ['.', 'web/pwa']) {
    module('node_modules/typescript/bin/tsc', '--noEmit', '--project', project);
  }
});
