/** Documents under many edits that nobody would make. */
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { makeDoor } from '../../web/api/door.js';
import type { Session } from '../../web/api/session.js';
import { JobError, engineDied } from '../../web/core/job-error.js';
import type { Pool } from '../../web/core/pool.js';
import type { DocumentEdit } from '../../web/model/document-edits.js';
import type { ModelFile } from '../../web/model/model-files.js';
import { checkFold } from './fold-check.js';
import { parseFold } from './fold-file.js';
import { foldText } from './fold-text.js';
import { objText, wavyRing } from './model-text.js';
import { Dice, randomEdit } from './random-edits.js';
import { schemaErrors } from './report-schema.js';
import { isEngineBuilt, withThreads, type Killing } from './thread-pool.js';

const options = { parts: 4, height: 60, compact: 'off', runs: 40 } as const;

/** More of them take minutes; `EDITS` asks for so many on each model, with one worker, with two, and with some that die. */
const editCount = Number(process.env['EDITS'] ?? 9);

const corpus = new URL('../data/corpus/', import.meta.url);
const own = (name: string): ModelFile => ({ name, bytes: readFileSync(new URL(name, corpus)) });
const models: ModelFile[] = [
  { name: 'ring.obj', bytes: new TextEncoder().encode(objText(wavyRing(10))) },
  own('rabbit.stl'),
  own('house-with-lid.obj'),
];

/** What is wrong with the present result. */
async function faultsOf(session: Session): Promise<string[]> {
  const { labels, model, pieces } = await session.result();
  const faces = pieces.flatMap(({ sources }) => [...sources]).sort((a, b) => a - b);
  const all = Array.from({ length: model.faces.length / 3 }, (_, face) => face);
  const faults = checkFold(parseFold(await foldText(session)));
  if (String(faces) !== String(all)) faults.push('not every face is in one piece');
  for (const { name, part, sources, flaps, assignments } of pieces) {
    if (sources.some((face) => labels[face] !== part)) faults.push(`${name} has faces of others`);
    if (flaps.edges.some((edge) => assignments[edge] !== 'B')) faults.push(`${name} glues a fold`);
  }
  return faults;
}

/** How an edit is made. */
type Apply = (session: Session, edit: DocumentEdit) => Promise<unknown>;

const apply: Apply = (session, edit) => session.apply([edit]);

/** Workers of which each is as likely to die at whatever it tells while an edit is made. */
class Mortals {
  deaths = 0;
  private isAtWork = false;
  private readonly dice = new Dice(5);

  constructor(private readonly victim: Killing['victim']) {}

  get killing(): Killing {
    return { victim: this.victim, times: Infinity, atMost: true, armed: () => this.isDue() };
  }

  /** A death changes nothing: the document is as before, and the same edit can be made. */
  readonly apply: Apply = async (session, edit) => {
    for (;;) {
      const before = JSON.stringify(session.edits);
      this.isAtWork = true;
      try {
        return await session.apply([edit]);
      } catch (error) {
        if (!(error instanceof JobError) || error.code !== engineDied) throw error;
        expect(JSON.stringify(session.edits)).toBe(before);
      } finally {
        this.isAtWork = false;
      }
    }
  };

  private isDue(): boolean {
    const isDue = this.isAtWork && this.dice.roll() < 0.2;
    if (isDue) ++this.deaths;
    return isDue;
  }
}

/** Makes random edits and undos, each of which must leave a sound document; gives the hash of the last result. */
async function scramble(session: Session, seed: number, make: Apply): Promise<string> {
  const dice = new Dice(seed);
  const first = await foldText(session);
  for (let i = 0; i < editCount; ++i) {
    const chance = dice.roll();
    if (chance < 0.1) session.undo();
    else if (chance < 0.15) session.redo();
    else await make(session, randomEdit(dice, await session.result()));
    const what = `seed ${seed}, edit ${i}: ${JSON.stringify(session.edits.at(-1))}`;
    expect(await faultsOf(session), what).toEqual([]);
  }
  expect(schemaErrors(session.report)).toEqual([]);
  const hash = session.report.result_hash;
  while (session.undo());
  expect(await foldText(session)).toBe(first);
  return hash;
}

/** Opens a model on some workers and edits it at random. */
async function hashAfter(
  file: ModelFile,
  seed: number,
  pool: Pool,
  make: Apply = apply,
): Promise<string> {
  const session = await makeDoor({
    startPool: () => pool,
    loadFont: () => Promise.reject(new Error('FOLD has no letters')),
    loadRenderer: () => Promise.reject(new Error('FOLD has no pictures')),
  }).open([file], { pool });
  await session.run(options);
  return scramble(session, seed, make);
}

describe.skipIf(!isEngineBuilt)('a session under random edits and undos', () => {
  it.each(models.map((file, seed) => ({ file, seed: seed + 7, name: file.name })))(
    'stays sound, whoever works on $name, and whoever dies over it',
    async ({ file, seed }) => {
      const expected = await withThreads(1, (pool) => hashAfter(file, seed, pool));
      expect(await withThreads(2, (pool) => hashAfter(file, seed, pool))).toBe(expected);
      for (const victim of ['conductor', 'helper'] as const) {
        const mortals = new Mortals(victim);
        const hash = await withThreads(
          2,
          (pool) => hashAfter(file, seed, pool, mortals.apply),
          mortals.killing,
        );
        expect(hash).toBe(expected);
        // Whether a helper has anything to do depends on the edits.
        if (victim === 'conductor') expect(mortals.deaths).toBeGreaterThan(0);
        if (editCount > 20) console.log(`${file.name}: ${mortals.deaths} deaths of a ${victim}`);
      }
    },
    3_600_000,
  );
});
