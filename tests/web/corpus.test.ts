import { describe, expect, it } from 'vitest';
import { checkedRun } from './checked-run.js';
import { isBuilt, runLimit, sharedFolder } from './command.js';
import { corpusCases, ownCases, type CorpusCase } from './corpus.js';

const shared = sharedFolder();

/** A tenth of the corpus, the same one every time; `npm run bench -- --full` runs all of it. */
const cases = shared === null ? [] : corpusCases(shared).filter((_, i) => i % 10 === 3);

async function expectSound({ path, parts }: CorpusCase): Promise<void> {
  const { ended, violations } = await checkedRun(path, ['--parts', parts]);
  expect(ended).toEqual({ status: 0, stdout: '', stderr: '' });
  expect(violations).toEqual([]);
}

describe.skipIf(!isBuilt)('nets of our own models can be cut out and folded', () => {
  it.concurrent.each(ownCases())('$model in $parts parts', expectSound, runLimit + 10_000);
});

describe.skipIf(shared === null || !isBuilt)(
  'nets of real models can be cut out and folded',
  () => {
    it.each(cases)('$model in $parts parts', expectSound, runLimit + 10_000);
  },
);
