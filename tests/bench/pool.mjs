// Learning with one worker and with two, in threads of node: prints the seconds, the best of three, and the speed-up.
import { Buffer } from 'node:buffer';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

const load = async (name) => {
  const path = fileURLToPath(new URL(`../../${name}`, import.meta.url));
  return (await runnerImport(path)).module;
};
const { runJob } = await load('web/core/client.ts');
const { defaultOptions } = await load('web/model/default-options.ts');
const { sharedFolder } = await load('tests/web/command.ts');
const { objText, wavyRing } = await load('tests/web/model-text.ts');
const { isEngineBuilt, withThreads } = await load('tests/web/thread-pool.ts');

const rounds = 3;

/** About a thousand faces, as a model from life if there is one. */
function model() {
  const shared = sharedFolder();
  if (shared === null) return Buffer.from(objText(wavyRing(22)));
  return readFileSync(join(shared, 'models', 'organic', 'cat_1000.obj'));
}

/** Seconds of learning in a pool that is warm: workers are started once, models come often. */
async function learnSeconds(workers, bytes) {
  return withThreads(workers, async (pool) => {
    const seconds = [];
    let hash = '';
    for (let round = 0; round <= rounds; ++round) {
      const result = await runJob(pool, bytes, 'model.obj', { ...defaultOptions, parts: 8 });
      if (round > 0) seconds.push(result.seconds.learn);
      hash = result.hash;
    }
    return { best: Math.min(...seconds), hash };
  });
}

if (!isEngineBuilt) {
  console.log('pool: skipped, not built');
  process.exit(1);
}
const bytes = model();
const one = await learnSeconds(1, bytes);
const two = await learnSeconds(2, bytes);
console.log(`pool: learning takes ${one.best.toFixed(2)} s with one worker`);
console.log(`pool: learning takes ${two.best.toFixed(2)} s with two workers`);
console.log(`pool: speed-up ${(one.best / two.best).toFixed(2)} (at least 1.6 on two free cores)`);
process.exit(one.hash === two.hash ? 0 : 1);
