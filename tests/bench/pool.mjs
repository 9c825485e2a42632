// Learning with one worker and with two, in threads of node: prints the seconds, the best of five, and the speed-up.
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

const rounds = 5;

/** About a thousand faces, as a model from life if there is one. */
function model() {
  const shared = sharedFolder();
  if (shared === null) return Buffer.from(objText(wavyRing(22)));
  return readFileSync(join(shared, 'models', 'organic', 'cat_1000.obj'));
}

/** Seconds of learning, and the hash of the result. */
async function learn(pool, bytes) {
  const { seconds, hash } = await runJob(pool, [{ name: 'model.obj', bytes }], {
    ...defaultOptions,
    parts: 8,
  });
  return { seconds: seconds.learn, hash };
}

/** Best times of both pools in turn, so that other load on the machine meets both alike. The first
 * round does not count: it starts the workers, which then stay from model to model. */
async function compare(one, two, bytes) {
  const best = [Infinity, Infinity];
  const hashes = new Set();
  for (let round = 0; round <= rounds; ++round) {
    for (const [i, pool] of [one, two].entries()) {
      const { seconds, hash } = await learn(pool, bytes);
      if (round > 0) best[i] = Math.min(best[i], seconds);
      hashes.add(hash);
    }
  }
  return { best, same: hashes.size === 1 };
}

if (!isEngineBuilt) {
  console.log('pool: skipped, not built');
  process.exit(1);
}
const { best, same } = await withThreads(1, (one) =>
  withThreads(2, (two) => compare(one, two, model())),
);
console.log(`pool: learning takes ${best[0].toFixed(2)} s with one worker`);
console.log(`pool: learning takes ${best[1].toFixed(2)} s with two workers`);
console.log(`pool: speed-up ${(best[0] / best[1]).toFixed(2)} (at least 1.6 on two free cores)`);
process.exit(same ? 0 : 1);
