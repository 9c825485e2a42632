// What it costs to split a part, and to merge it again, beside the whole run: seconds with one worker, as WASM under node. `node tests/bench/edits.mjs [MODEL.obj]...`
import { readFileSync, readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

const load = async (name) => {
  const path = fileURLToPath(new URL(`../../${name}`, import.meta.url));
  return (await runnerImport(path)).module;
};
const { runJob } = await load('web/core/client.ts');
const { defaultOptions } = await load('web/model/default-options.ts');
const { merging, splitting, startFrom } = await load('web/model/edits.ts');
const { sharedFolder } = await load('tests/web/command.ts');
const { isEngineBuilt, withThreads } = await load('tests/web/thread-pool.ts');

const parts = 8;

function models() {
  if (process.argv.length > 2) return process.argv.slice(2);
  const folder = join(sharedFolder() ?? '', 'models', 'organic');
  return readdirSync(folder)
    .filter((name) => name.endsWith('_1000.obj'))
    .map((name) => join(folder, name));
}

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** Splits each part in two and merges the halves again. */
async function measure(pool, path) {
  const bytes = readFileSync(path);
  const run = (start) =>
    runJob(
      pool,
      [{ name: basename(path), bytes }],
      { ...defaultOptions, parts },
      start && { start },
    );
  const whole = await run();
  const [splits, merges] = [[], []];
  let pieces = 0;
  for (let part = 0; part < whole.parts; ++part) {
    const split = await run(startFrom(whole, [splitting(part)]));
    splits.push(split.seconds.total);
    const merged = await run(startFrom(split, [merging([part, whole.parts])]));
    merges.push(merged.seconds.total);
    pieces += split.pieces.length - whole.parts - 1 + merged.pieces.length - whole.parts;
  }
  const row = [
    whole.seconds.total,
    mean(splits),
    Math.max(...splits),
    mean(merges),
    Math.max(...merges),
  ];
  console.log(
    basename(path).padEnd(22) +
      row.map((s) => s.toFixed(2).padStart(9)).join('') +
      String(pieces).padStart(9),
  );
  return row;
}

if (!isEngineBuilt) {
  console.log('edits: skipped, not built');
  process.exit(1);
}
const heads = ['whole', 'split', 'slowest', 'merge', 'slowest', 'extra'];
console.log('seconds'.padEnd(22) + heads.map((head) => head.padStart(9)).join(''));
const rows = await withThreads(1, async (pool) => {
  // The first job starts the worker.
  const all = [];
  for (const path of [models()[0], ...models()]) all.push(await measure(pool, path));
  return all.slice(1);
});
console.log(
  'mean'.padEnd(22) +
    rows[0]
      .map((_, i) =>
        mean(rows.map((row) => row[i]))
          .toFixed(2)
          .padStart(9),
      )
      .join(''),
);
