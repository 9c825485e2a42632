// What the command says of itself.
import { execFileSync } from 'node:child_process';

export default () =>
  execFileSync(process.execPath, ['dist/cli/foldwright.js', '--help'], {
    encoding: 'utf8',
    env: { ...process.env, COLUMNS: '100' },
  });
