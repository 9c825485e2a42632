/** Every nasty file of other people with each step of the repair off: a surface that can be unfolded, or a sentence. */
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import type { Inspection } from '../../web/api/inspect.js';
import { Session } from '../../web/api/session.js';
import { Exit } from '../../web/cli/exit.js';
import { readModelFiles } from '../../web/cli/read-model-files.js';
import { JobError } from '../../web/core/job-error.js';
import type { Pool } from '../../web/core/pool.js';
import { switchableSteps, writtenRepair } from '../../web/model/repair-steps.js';
import { isModelName } from '../../web/model/model-files.js';
import { english } from '../../web/words/en/index.js';
import { phraseOf } from '../../web/words/phrase.js';
import { sharedFolder } from './command.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

const shared = sharedFolder();
const none = (): Promise<Uint8Array> => Promise.reject(new Error('nothing is drawn here'));

function modelsBelow(folder: string): string[] {
  return readdirSync(join(shared!, folder), { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))
    .filter((path) => isModelName(path))
    .sort();
}

/** What is wrong with a surface that nets shall be made of; empty if nothing is. */
function faultOf({ model: { faces, vertices } }: Inspection): string {
  if (faces.length === 0) return 'no faces';
  if (vertices.some((x) => !Number.isFinite(x))) return 'a place that is none';
  const directed = new Set<string>();
  for (let f = 0; f < faces.length; f += 3) {
    const corners = [...faces.subarray(f, f + 3)];
    if (new Set(corners).size < 3) return `face ${f / 3} has two corners at one vertex`;
    for (const [i, from] of corners.entries()) {
      const edge = `${from} ${corners[(i + 1) % 3]}`;
      if (directed.has(edge)) return `two faces run along edge ${edge} in one direction`;
      directed.add(edge);
    }
  }
  return '';
}

async function problemWith(pool: Pool, path: string, repair: string): Promise<string> {
  try {
    const surroundings = { pool: () => pool, loadFont: none, loadRenderer: none };
    const look = await new Session(readModelFiles(path), surroundings).inspect({ repair });
    const told = look.repairs.map((message) => phraseOf(english, message));
    return told.includes('') ? 'a repair without a sentence' : faultOf(look);
  } catch (error) {
    if (error instanceof Exit) return '';
    if (!(error instanceof JobError)) throw error;
    return error.code === 'internal' || error.code === 'engine-died' ? error.message : '';
  }
}

describe.skipIf(shared === null || !isEngineBuilt)('files with faults', () => {
  const wishes = [...switchableSteps.map((step) => [step]), switchableSteps].map(writtenRepair);

  it.each(wishes)('are read with %s', { timeout: 600_000 }, (repair) =>
    withThreads(1, async (pool) => {
      const paths = ['nasty', 'cases'].flatMap(modelsBelow);
      expect(paths.length).toBeGreaterThan(100);
      for (const path of paths) expect(await problemWith(pool, path, repair), path).toBe('');
    }),
  );
});
