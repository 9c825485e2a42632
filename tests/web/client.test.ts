import { afterEach, describe, expect, it, vi } from 'vitest';
import { runJob } from '../../web/core/client.js';
import { defaultPatience } from '../../web/core/job-run.js';
import type { Pool } from '../../web/core/pool.js';
import type { TimedEngineEvent } from '../../web/core/protocol.js';
import { defaultOptions } from '../../web/model/default-options.js';
import type { EngineEvent } from '../../web/model/job.js';
import { tetrahedronResult } from './fixtures.js';
import { withoutLooks } from './engine-result.js';
import {
  busyPort,
  deafPort,
  engineOf,
  localPort,
  mortalPort,
  poolOf,
  type Script,
} from './local-pool.js';

const done: EngineEvent[] = [{ type: 'done', result: withoutLooks(tetrahedronResult()) }];
const progress = (value: number): EngineEvent => ({
  type: 'stage',
  stage: 'search',
  progress: value,
});

/** Workers of which all do the same. */
function poolFor(script: Script, size = 1) {
  return poolOf(size, (listener) => localPort(engineOf(script), listener));
}

const files = [{ name: 'model.obj', bytes: new Uint8Array(3) }];

function run(pool: Pool, options: Parameters<typeof runJob>[3] = {}) {
  return runJob(pool, files, defaultOptions, options);
}

describe('runJob', () => {
  it('resolves with the result and its times', async () => {
    const { pool } = poolFor({ steps: [[progress(0.1)], [progress(0.9)], done] });
    const result = await run(pool);
    expect(result.parts).toBe(1);
    expect(result.seconds.total).toBeGreaterThanOrEqual(result.seconds.search);
  });

  it('hands all files to the conductor, once, and leaves them to the asker', async () => {
    const several = [...files, { name: 'model.mtl', bytes: new Uint8Array(5) }];
    const engine = engineOf({ steps: [done] });
    const createJob = vi.spyOn(engine, 'createJob');
    const moved: ArrayBuffer[][] = [];
    const { pool } = poolOf(2, (listener) => {
      const port = localPort(engine, listener);
      const post: typeof port.post = (request, transfer) => {
        if (request.type === 'run') moved.push(transfer);
        port.post(request, transfer);
      };
      return { ...port, post };
    });
    await runJob(pool, several, defaultOptions);
    expect(createJob.mock.calls).toEqual([[several, defaultOptions, null]]);
    expect(moved).toEqual([[]]);
  });

  it('rejects with the code and sentence of an error', async () => {
    const badIndex = { place: 'line', at: 3, what: 'beyond', index: 9, vertices: 8, first: 1 };
    const { pool } = poolFor({
      steps: [[{ type: 'error', code: 'bad-index', params: badIndex }]],
    });
    const heard: TimedEngineEvent[] = [];
    const message = 'line 3: face refers to vertex 9, but the file has 8 vertices';
    await expect(run(pool, { onEvent: (event) => heard.push(event) })).rejects.toMatchObject({
      name: 'JobError',
      code: 'bad-index',
      params: badIndex,
      message,
    });
    expect(heard.at(-1)).toMatchObject({ type: 'error', code: 'bad-index', text: message });
  });

  it('cancels a running job and keeps its workers', async () => {
    const { pool, spawned } = poolFor({ steps: [[progress(0.5)]] });
    const control = new AbortController();
    const aborted = run(pool, {
      signal: control.signal,
      onEvent: () => control.abort(),
    });
    await expect(aborted).rejects.toMatchObject({ name: 'AbortError' });
    expect([spawned.count, pool.workers.length]).toEqual([1, 1]);
  });

  it('replaces a worker that does not answer a cancel', async () => {
    const { pool, spawned } = poolOf(1, (listener, worker) =>
      worker === 0 ? deafPort() : localPort(engineOf({ steps: [done] }), listener),
    );
    const control = new AbortController();
    const aborted = run(pool, { signal: control.signal });
    setImmediate(() => control.abort());
    const next = run(pool);
    await expect(aborted).rejects.toMatchObject({ name: 'AbortError' });
    await expect(next).resolves.toMatchObject({ parts: 1 });
    expect(spawned.count).toBe(2);
  });

  it('waits for the nets of a worker that is slow to answer a stop, unless it is cancelled', async () => {
    const net: EngineEvent = { type: 'net', part: 0, piece: 0 };
    for (const [steps, isCancelled] of [
      [[[net], [progress(0.5)]], false],
      [[[net], [progress(0.5)]], true],
      [[[progress(0.5)]], false],
    ] as const) {
      const { pool, spawned } = poolOf(1, (listener) =>
        busyPort(
          engineOf({ steps: steps.map((step) => [...step]) }),
          listener,
          3 * defaultPatience,
        ),
      );
      const [stop, cancel] = [new AbortController(), new AbortController()];
      const heard = new Set<string>();
      const onEvent = ({ type }: TimedEngineEvent): void => {
        heard.add(type);
        stop.abort();
        if (isCancelled) cancel.abort();
      };
      const ended = run(pool, { signal: cancel.signal, stop: stop.signal, onEvent });
      await expect(ended).rejects.toMatchObject({ name: 'AbortError' });
      const isAwaited = steps.length > 1 && !isCancelled;
      expect(heard.has('cancelled')).toBe(isAwaited);
      expect([spawned.count, pool.workers.length]).toEqual([1, isAwaited ? 1 : 0]);
    }
  });

  it('hands over a result that is done when the end is asked for', async () => {
    const { pool } = poolFor({ steps: [[{ type: 'net', part: 0, piece: 0 }, ...done]] });
    const control = new AbortController();
    const heard: TimedEngineEvent[] = [];
    const onEvent = (event: TimedEngineEvent): void => {
      heard.push(event);
      if (event.type === 'net') control.abort();
    };
    const aborted = run(pool, { signal: control.signal, onEvent });
    await expect(aborted).rejects.toMatchObject({ name: 'AbortError' });
    expect(heard.at(-1)).toMatchObject({ type: 'cancelled', best: { parts: 1 } });
  });

  it('never starts a job that was aborted before', async () => {
    const { pool, spawned } = poolFor({ steps: [done] });
    await expect(run(pool, { signal: AbortSignal.abort() })).rejects.toThrow();
    expect(spawned.count).toBe(0);
  });

  it('fails when the conductor dies, and replaces it for the next run', async () => {
    const { pool, spawned } = poolOf(1, (listener, worker) =>
      mortalPort(engineOf({ steps: [done] }), listener, () => worker === 0),
    );
    await expect(run(pool)).rejects.toMatchObject({
      code: 'engine-died',
      message: 'The engine stopped unexpectedly: memory access out of bounds',
    });
    await expect(run(pool)).resolves.toMatchObject({ parts: 1 });
    expect(spawned.count).toBe(2);
  });

  it('starts no second worker where one is warm', async () => {
    const { pool, spawned } = poolFor({ steps: [done] });
    pool.warm();
    pool.warm();
    await run(pool);
    expect(spawned.count).toBe(1);
  });

  it('replaces a warm worker that dies before it tells anything', async () => {
    const { pool, spawned } = poolOf(1, (listener, worker) =>
      mortalPort(engineOf({ steps: [done] }), listener, () => worker === 0),
    );
    pool.warm();
    await expect(run(pool)).resolves.toMatchObject({ parts: 1 });
    expect(spawned.count).toBe(2);
  });

  it('fails when the worker after a warm one dies, too', async () => {
    const { pool, spawned } = poolOf(1, (listener) =>
      mortalPort(engineOf({ steps: [done] }), listener, () => true),
    );
    pool.warm();
    await expect(run(pool)).rejects.toMatchObject({ code: 'engine-died' });
    expect([spawned.count, pool.workers.length]).toEqual([2, 0]);
  });

  it('runs jobs in the order in which they were given', async () => {
    const { pool } = poolFor({ steps: [[progress(0.5)], done] });
    const order: number[] = [];
    await Promise.all([0, 1, 2].map((i) => run(pool).then(() => order.push(i))));
    expect(order).toEqual([0, 1, 2]);
  });

  it('tells the last of each kind before the end', async () => {
    const steps = Array.from({ length: 60 }, (_, i) => [progress(i / 60)]);
    const { pool } = poolFor({ steps: [...steps, done] });
    const heard: TimedEngineEvent[] = [];
    await run(pool, { onEvent: (event) => heard.push(event) });
    expect(heard.length).toBeLessThan(60);
    expect(heard.slice(-2)).toMatchObject([{ type: 'stage', progress: 59 / 60 }, { type: 'done' }]);
  });

  it('fails a job whose workers are closed under it', async () => {
    const { pool } = poolFor({ steps: [[progress(0.5)]] });
    const failed = run(pool, { onEvent: () => pool.close() });
    await expect(failed).rejects.toMatchObject({ code: 'engine-died' });
  });
});

describe('runJob in a pool that is closed', () => {
  it('fails before its warm worker has told anything, and starts none', async () => {
    const { pool, spawned } = poolOf(1, () => deafPort());
    pool.warm();
    const failed = run(pool);
    setImmediate(() => pool.close());
    await expect(failed).rejects.toMatchObject({ code: 'engine-died' });
    expect([spawned.count, pool.workers.length]).toEqual([1, 0]);
  });
});

describe('runJob with helpers', () => {
  const script: Script = { steps: [[progress(0.1)], [progress(0.9)], done], tasks: 6, length: 40 };

  it('starts them when tasks wait, and no more than fit', async () => {
    const { pool, spawned } = poolFor(script, 3);
    await run(pool);
    expect(spawned.count).toBe(3);
    await run(pool);
    expect(spawned.count).toBe(3);
  });

  it('starts none for tasks that take but a moment', async () => {
    const { pool, spawned } = poolFor({ ...script, length: 1 }, 3);
    await run(pool);
    expect(spawned.count).toBe(1);
  });

  it('runs the task of one that died again', async () => {
    const { pool, spawned } = poolOf(2, (listener, worker) =>
      mortalPort(engineOf(script), listener, ({ type }) => worker === 1 && type === 'task'),
    );
    await expect(run(pool)).resolves.toMatchObject({ parts: 1 });
    expect(spawned.count).toBe(3);
  });

  it('does without them where none can be started', async () => {
    const { pool, spawned } = poolOf(2, (listener, worker) => {
      if (worker === 0) return localPort(engineOf(script), listener);
      setImmediate(() => listener.onDeath('its script could not be loaded'));
      return deafPort();
    });
    await expect(run(pool)).resolves.toMatchObject({ parts: 1 });
    expect(spawned.count).toBe(2);
  });

  it('fails a job of which a task ends three of them', async () => {
    const { pool } = poolOf(2, (listener, worker) =>
      mortalPort(engineOf(script), listener, ({ type }) => worker > 0 && type === 'task'),
    );
    await expect(run(pool)).rejects.toMatchObject({
      code: 'engine-died',
      message:
        'The engine stopped unexpectedly 3 times at the same task: memory access out of bounds',
    });
  });

  it('replaces those that do not answer a cancel', async () => {
    const { pool } = poolOf(2, (listener, worker) =>
      worker === 1 ? deafPort() : localPort(engineOf({ ...script, tasks: 2 }), listener),
    );
    // The second worker keeps its task for ever.
    const signal = AbortSignal.timeout(300);
    await expect(run(pool, { signal })).rejects.toMatchObject({ name: 'TimeoutError' });
    expect(pool.workers).toHaveLength(1);
    await expect(run(pool)).resolves.toMatchObject({ parts: 1 });
  });
});

describe('a pool without jobs', () => {
  const script: Script = { steps: [[progress(0.1)], done], tasks: 6, length: 40 };

  // Messages between these workers do not wait for timers.
  const stopTheClock = (): unknown => vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  afterEach(() => void vi.useRealTimers());

  it('keeps its helpers for half a minute, and then one worker', async () => {
    stopTheClock();
    const { pool, spawned } = poolFor(script, 3);
    await run(pool);
    vi.advanceTimersByTime(29_999);
    expect(pool.workers).toHaveLength(3);
    vi.advanceTimersByTime(1);
    expect(pool.workers).toHaveLength(1);
    await run(pool);
    expect([pool.workers.length, spawned.count]).toEqual([3, 5]);
  });

  it('begins to wait anew with every job', async () => {
    stopTheClock();
    const { pool } = poolFor(script, 3);
    await run(pool);
    vi.advanceTimersByTime(20_000);
    await run(pool);
    vi.advanceTimersByTime(20_000);
    expect(pool.workers).toHaveLength(3);
  });
});
