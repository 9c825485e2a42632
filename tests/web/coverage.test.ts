/** What becomes of every file of other people's: read, repaired or refused, and as what. */
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import type { Inspection } from '../../web/api/inspect.js';
import { Session } from '../../web/api/session.js';
import { readModelFiles } from '../../web/cli/read-model-files.js';
import { Exit } from '../../web/cli/exit.js';
import { JobError } from '../../web/core/job-error.js';
import type { Pool } from '../../web/core/pool.js';
import type { Message } from '../../web/model/message.js';
import { count } from '../../web/words/en/numbers.js';
import { sharedFolder } from './command.js';
import { expectGolden } from './golden.js';
import { modelsBelow } from './corpus.js';
import { volumeOf } from './read-model.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

const shared = sharedFolder();
const none = (): Promise<Uint8Array> => Promise.reject(new Error('nothing is drawn here'));

/** One row of the table. */
interface Row {
  path: string;
  outcome: 'read' | 'repaired' | 'refused';
  /** Codes, with how many things they are about. */
  what: string;
  faces: number;
  bodies: number;
  /** Of three digits; of closed models only. */
  volume: number | null;
}

/** What only tells something of a model, and changes nothing. */
const remarks = [
  'large-model',
  'open-border',
  'open-holes',
  'inner-bodies',
  'triangulated-polygons',
  'crossing-bodies',
  'self-crossing-bodies',
  'crossings-unchecked',
];

function wordsOf({ code, params }: Message): string {
  return typeof params['count'] === 'number' ? `${code} ${params['count']}` : code;
}

function rowOf(path: string, { model, repairs, components }: Inspection): Row {
  const codes = repairs.map(({ code }) => code);
  const isRepaired = codes.some((code) => !remarks.includes(code));
  const triangles = { positions: [...model.vertices], corners: [...model.faces] };
  return {
    path,
    outcome: isRepaired ? 'repaired' : 'read',
    what: repairs.map(wordsOf).join(', '),
    faces: model.faces.length / 3,
    bodies: components.length,
    volume: codes.includes('open-border') ? null : Number(volumeOf(triangles).toPrecision(3)),
  };
}

async function outcomeOf(pool: Pool, path: string): Promise<Row> {
  const refused = { path, outcome: 'refused', faces: 0, bodies: 0, volume: null } as const;
  try {
    const files = readModelFiles(join(shared!, path));
    const session = new Session(files, { pool: () => pool, loadFont: none, loadRenderer: none });
    return rowOf(path, await session.inspect());
  } catch (error) {
    if (error instanceof Exit) return { ...refused, what: 'not taken' };
    if (!(error instanceof JobError)) throw error;
    const { what } = error.params;
    return { ...refused, what: typeof what === 'string' ? `${error.code}: ${what}` : error.code };
  }
}

function lineOf({ path, outcome, what, faces, bodies, volume }: Row): string {
  const shape =
    outcome === 'refused'
      ? ''
      : `${count(faces, 'face')}, ${count(bodies, 'body', 'bodies')}, ${volume === null ? 'open' : `volume ${volume}`}`;
  return [path, outcome, shape, what].filter((word) => word !== '').join(' | ');
}

/** Files of the same shape, by what their descriptions say: their triangles and volume, in one body. */
const known: readonly (readonly [RegExp, number, number])[] = [
  [/synthetic\/cube(?!_open|.*truncated)/, 12, 1],
  [/gltf\/skull-(?!mirrored)/, 344, 0.43],
  [/models\/pdo\//, 16, 12000],
];

/** The table is tests/data/coverage.txt: whatever changes in it is to be looked at. */
describe.skipIf(shared === null || !isEngineBuilt)('files of other people', () => {
  it('are read, repaired or refused as ever', { timeout: 600_000 }, () =>
    withThreads(1, async (pool) => {
      const rows: Row[] = [];
      for (const path of ['models', 'nasty'].flatMap((folder) => modelsBelow(shared!, folder))) {
        rows.push(await outcomeOf(pool, path));
      }
      const counts = (['read', 'repaired', 'refused'] as const).map((outcome) => {
        return `${outcome}: ${rows.filter((row) => row.outcome === outcome).length}`;
      });
      for (const [names, faces, volume] of known) {
        const shapes = rows.filter(
          ({ path, outcome }) => names.test(path) && outcome !== 'refused',
        );
        expect(shapes.length).toBeGreaterThan(3);
        const expected = shapes.map(({ path }) => [path, faces, 1, volume]);
        expect(shapes.map((row) => [row.path, row.faces, row.bodies, row.volume])).toEqual(
          expected,
        );
      }
      expectGolden('coverage.txt', [...counts, '', ...rows.map(lineOf), ''].join('\n'));
    }),
  );
});
