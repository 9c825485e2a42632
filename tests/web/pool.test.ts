/** The real engine in real threads: the same bits however many there are, and whatever happens. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { runJob, type TimedEngineResult } from '../../web/core/client.js';
import type { Pool } from '../../web/core/pool.js';
import type { TimedEngineEvent } from '../../web/core/protocol.js';
import { writeFold } from '../../web/export/fold.js';
import { defaultOptions } from '../../web/model/default-options.js';
import type { EngineResult } from '../../web/model/job.js';
import type { JobOptions, Solver } from '../../web/model/job-options.js';
import { stages } from '../../web/model/stages.js';
import { sharedFolder } from './command.js';
import { withoutLooks } from './engine-result.js';
import { objText, wavyRing } from './model-text.js';
import { isEngineBuilt, withThreads, type Killing } from './thread-pool.js';

type Hear = (event: TimedEngineEvent) => void;

const ring = (n: number): Uint8Array => new TextEncoder().encode(objText(wavyRing(n)));

function unfold(
  pool: Pool,
  bytes: Uint8Array,
  options: Partial<JobOptions> = {},
  onEvent: Hear = () => undefined,
): Promise<TimedEngineResult> {
  const all = { ...defaultOptions, parts: 8, ...options };
  return runJob(pool, [{ name: 'model.obj', bytes }], all, { onEvent, pictures: true });
}

function unfoldWith(
  workers: number,
  bytes: Uint8Array,
  options: Partial<JobOptions> = {},
  killing?: Killing,
): Promise<TimedEngineResult> {
  return withThreads(workers, (pool) => unfold(pool, bytes, options), killing);
}

const shared = sharedFolder();
/** With what is asked of their nets: compaction takes long, and one model shows that it is shared out. */
const models: [string, Uint8Array, Partial<JobOptions>][] = [
  ['a ring of 128 faces', ring(8), { compaction: true }],
  ['a ring of 288 faces', ring(12), { compaction: false }],
];
if (shared) {
  const cat = join(shared, 'models', 'organic', 'cat_300.obj');
  models.push(['a cat of 300 faces', readFileSync(cat), { compaction: false }]);
}
const solvers: Solver[] = ['tree', 'genetic'];
const cases = models.flatMap(([name, bytes, options]) =>
  solvers.map((solver) => ({ name, bytes, solver, options })),
);

/** Hears that the generations of every part count up from 1. */
class GenerationCount {
  /** By part. */
  readonly generations = new Map<number, number>();
  pictures = 0;

  readonly hear: Hear = (event) => {
    if (event.type !== 'generation') return;
    expect(event.generation).toBe((this.generations.get(event.part) ?? 0) + 1);
    this.generations.set(event.part, event.generation);
    if (event.net) ++this.pictures;
  };
}

describe.skipIf(!isEngineBuilt)('a pool of threads', () => {
  it('tells of sheets that could be printed while nets get better, which changes nothing', async () => {
    const bytes = ring(12);
    const run = (drafts: boolean, onEvent: Hear = () => undefined): Promise<TimedEngineResult> =>
      withThreads(2, (pool) =>
        runJob(
          pool,
          [{ name: 'model.obj', bytes }],
          { ...defaultOptions, parts: 8, compaction: true },
          { onEvent, drafts },
        ),
      );
    const told: TimedEngineEvent[] = [];
    const result = await run(true, (event) => told.push(event));
    const drafts = told.flatMap((event) => (event.type === 'draft' ? [event.result] : []));
    expect(drafts.length).toBeGreaterThan(0);
    for (const draft of drafts) {
      const faces = draft.pieces.flatMap(({ sources }) => [...sources]).sort((a, b) => a - b);
      expect(faces).toEqual(Array.from({ length: 288 }, (_, face) => face));
      expect(draft.pieces.every(({ overlaps }) => overlaps === 0)).toBe(true);
      expect(draft.sheets.length).toBeGreaterThan(0);
    }
    expect(told.at(-1)!.type).toBe('done');
    const { hash } = await run(false, ({ type }) => expect(type).not.toBe('draft'));
    expect(hash).toBe(result.hash);
  });

  it.each(cases)('gives one result for $name by $solver', async ({ bytes, solver, options }) => {
    const one = await unfoldWith(1, bytes, { solver, ...options });
    for (const workers of [2, 4]) {
      const other = await unfoldWith(workers, bytes, { solver, ...options });
      expect(other.hash).toBe(one.hash);
      expect(other.search).toEqual(one.search);
      expect(writeFold(withoutLooks(other)) === writeFold(withoutLooks(one))).toBe(true);
    }
  });

  it.each([1, 2])('gives the same result when %i of its workers die at a task', async (times) => {
    const one = await unfoldWith(1, ring(12), { compaction: false });
    const killing: Killing = { victim: 'helper', times };
    const other = await unfoldWith(2, ring(12), { compaction: false }, killing);
    expect(other.hash).toBe(one.hash);
  });

  it('fails when a task ends three workers', async () => {
    const failed = unfoldWith(2, ring(30), {}, { victim: 'helper', times: 3 });
    await expect(failed).rejects.toMatchObject({
      code: 'engine-died',
      message: expect.stringMatching(/^The engine stopped unexpectedly 3 times/) as string,
    });
  });

  it('fails when the conductor dies, and works on', () =>
    withThreads(
      2,
      async (pool) => {
        await expect(unfold(pool, ring(20))).rejects.toMatchObject({
          code: 'engine-died',
          message: 'The engine stopped unexpectedly: its thread ended with status 1',
        });
        expect((await unfold(pool, ring(6))).parts).toBe(8);
      },
      { victim: 'conductor', times: 1 },
    ));

  it.each(stages)('ends a run that is cancelled in the stage %s, and works on', (stage) =>
    withThreads(2, async (pool) => {
      const control = new AbortController();
      const options = { ...defaultOptions, parts: 4 };
      const run = runJob(pool, [{ name: 'model.obj', bytes: ring(12) }], options, {
        signal: control.signal,
        onEvent: (event) => {
          if (event.type === 'stage' && event.stage === stage) control.abort();
        },
      });
      await expect(run).rejects.toMatchObject({ name: 'AbortError' });
      expect((await unfold(pool, ring(6), { compaction: false })).parts).toBe(8);
    }),
  );

  it('keeps the nets that were found before a run was cancelled', () =>
    withThreads(1, async (pool) => {
      const control = new AbortController();
      let best: EngineResult | undefined;
      // The genetic search takes its time over a ring, so that parts are left without a net.
      const options: JobOptions = { ...defaultOptions, parts: 8, solver: 'genetic' };
      const run = runJob(pool, [{ name: 'model.obj', bytes: ring(14) }], options, {
        signal: control.signal,
        // However busy the machine is: the nets are what is looked at here.
        patience: 60_000,
        onEvent(event) {
          if (event.type === 'net') control.abort();
          if (event.type === 'cancelled') best = event.best;
        },
      });
      await expect(run).rejects.toMatchObject({ name: 'AbortError' });
      expect(best?.pieces.length).toBeGreaterThan(0);
      expect(best?.pieces.every(({ overlaps }) => overlaps === 0)).toBe(true);
    }));

  it.each(solvers)('tells every generation of every part by %s', async (solver) => {
    const count = new GenerationCount();
    const options = { solver, parts: 4, compaction: false };
    await withThreads(2, (pool) => unfold(pool, ring(10), options, count.hear));
    expect(count.generations.size).toBeGreaterThan(0);
    expect(count.pictures).toBeGreaterThan(0);
  });

  it('tells no generation twice when workers die over searches', async () => {
    const counts = [new GenerationCount(), new GenerationCount()];
    const options: Partial<JobOptions> = { solver: 'genetic', parts: 4, compaction: false };
    for (const [times, count] of counts.entries()) {
      const armed = (): boolean => count.generations.size > 0;
      await withThreads(2, (pool) => unfold(pool, ring(10), options, count.hear), {
        victim: 'helper',
        times,
        armed,
      });
    }
    expect(counts[1]!.generations).toEqual(counts[0]!.generations);
  });

  it('never tells of less progress than before', async () => {
    const progress: number[] = [];
    const hear: Hear = (event) => {
      if (event.type === 'stage') progress.push(event.progress);
    };
    await withThreads(2, (pool) => unfold(pool, ring(12), {}, hear));
    expect(progress).toEqual([...progress].sort((a, b) => a - b));
  });
});
