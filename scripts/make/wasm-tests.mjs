import { availableParallelism } from 'node:os';
import { root } from '../setup/paths.mjs';
import { runTogether } from '../setup/shell.mjs';

/**
 * Runs a program of tests that was built as WASM, shared out over the machine's cores.
 *
 * @param env its environment
 */
export function runWasmTests(program, env) {
  // GoogleTest's own way to share tests out: each process has one thread.
  const count = availableParallelism();
  const shard = (_, i) => ({
    cwd: root,
    env: { ...env, GTEST_TOTAL_SHARDS: String(count), GTEST_SHARD_INDEX: String(i) },
  });
  const command = [`build/wasm/${program}.cjs`, '--gtest_brief=1'];
  return runTogether(process.execPath, command, Array.from({ length: count }, shard));
}
