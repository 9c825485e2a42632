// Fuzzes all readers and the way from a file to nets: `npm run fuzz [-- SECONDS]`, 600 s for each program by default.
// Prints how many inputs each ran. What it finds stays in build/fuzz/findings; inputs that reach new code are kept in
// build/fuzz/inputs, and the next run begins with them.
import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { buildEngine } from './make/engine.mjs';
import { setUp } from './setup/index.mjs';
import { root } from './setup/paths.mjs';
import { main, SetupError } from './setup/shell.mjs';

const folder = join(root, 'build/fuzz');
const seeds = ['tests/data/corpus', 'tests/repro'].map((name) => join(root, name));

function secondsAskedFor(text = '600') {
  const seconds = Number(text);
  if (Number.isInteger(seconds) && seconds > 0) return seconds;
  throw new SetupError(`seconds for each program must be a whole number above 0, not '${text}'`);
}

/** Names of the programs that were built, without what they all begin with. */
function programs() {
  const names = readdirSync(folder).flatMap((file) => /^fuzz_(\w+)$/.exec(file)?.[1] ?? []);
  return names.sort();
}

/** Runs one program and says how many inputs it ran, and whether one broke a promise. */
function fuzz(name, seconds) {
  const inputs = join(folder, 'inputs', name);
  const findings = join(folder, 'findings', name);
  for (const path of [inputs, findings]) mkdirSync(path, { recursive: true });
  const { status, stderr } = spawnSync(
    join(folder, `fuzz_${name}`),
    [
      `-dict=${join(root, 'tests/fuzz/words.dict')}`,
      `-max_total_time=${seconds}`,
      `-artifact_prefix=${findings}/`,
      '-timeout=120',
      '-print_final_stats=1',
      inputs,
      ...seeds,
    ],
    { encoding: 'utf8', maxBuffer: 1 << 30, stdio: ['ignore', 'inherit', 'pipe'] },
  );
  const executions = stderr.match(/number_of_executed_units: (\d+)/)?.[1];
  console.log(`${name}: ${executions ?? 'an unknown number of'} executions in ${seconds} s`);
  if (status === 0) return true;
  console.log(stderr.split('\n').slice(-60).join('\n'));
  console.log(`${name}: found ${readdirSync(findings).join(', ')} in ${findings}`);
  return false;
}

/** The readers of GLB, glTF, 3MF, PDO and ZIP, with files that are damaged otherwise each time. */
function fuzzReaders(seconds) {
  const vitest = join(root, 'node_modules/vitest/vitest.mjs');
  const args = [vitest, 'run', '--project', 'web', 'tests/web/broken-files.test.ts'];
  const env = { ...process.env, FOLDWRIGHT_FUZZ_SECONDS: String(seconds) };
  return spawnSync(process.execPath, args, { cwd: root, env, stdio: 'inherit' }).status === 0;
}

await main(() => {
  const seconds = secondsAskedFor(process.argv[2]);
  setUp({ withBrowser: true });
  buildEngine('fuzz', ['fuzzers']);
  const failed = programs().filter((name) => !fuzz(name, seconds));
  if (!fuzzReaders(seconds)) failed.push('the readers in TypeScript');
  if (failed.length > 0) throw new SetupError(`${failed.join(', ')} broke a promise`);
});
