import { describe, expect, it } from 'vitest';
import { runJob } from '../../web/core/client.js';
import { serveEngine, type Engine } from '../../web/core/engine-worker.js';
import type { Answer, Request, TimedEvent } from '../../web/core/protocol.js';
import { Transport, type PortListener } from '../../web/core/transport.js';
import { defaultOptions } from '../../web/model/default-options.js';
import type { JobEvent } from '../../web/model/job.js';
import { tetrahedronResult } from './fixtures.js';

const done: JobEvent[] = [{ type: 'done', result: tetrahedronResult() }];
const progress = (value: number): JobEvent => ({ type: 'stage', stage: 'search', progress: value });

/** An engine whose jobs go through these steps and then repeat the last one. */
function engineOf(steps: JobEvent[][]): Engine {
  return {
    createJob() {
      let next = 0;
      return {
        step() {
          return steps[Math.min(next++, steps.length - 1)]!;
        },
        delete() {
          next = NaN;
        },
      };
    },
  };
}

/** A worker in this thread; `deaf` ones take requests and answer nothing. */
function localPort(engine: Engine, listener: PortListener, deaf: boolean) {
  let open = true;
  const later = (call: () => void) => setImmediate(() => open && call());
  const handle = serveEngine({
    loadEngine: () => Promise.resolve(engine),
    post: (answer: Answer) => later(() => listener.onAnswer(answer)),
    pause: () => new Promise((resolve) => setImmediate(resolve)),
  });
  return {
    post: (request: Request) => deaf || later(() => handle(request)),
    close: () => {
      open = false;
    },
  };
}

function transportOf(engine: Engine, deaf: (worker: number) => boolean = () => false) {
  const spawned = { count: 0 };
  const transport = new Transport((listener) => localPort(engine, listener, deaf(spawned.count++)));
  return { transport, spawned };
}

function run(transport: Transport, options: Parameters<typeof runJob>[4] = {}) {
  return runJob(transport, new Uint8Array(3), 'model.obj', defaultOptions, options);
}

describe('runJob', () => {
  it('resolves with the result and its times', async () => {
    const { transport } = transportOf(engineOf([[progress(0.1)], [progress(0.9)], done]));
    const result = await run(transport);
    expect(result.parts).toBe(1);
    expect(result.seconds.total).toBeGreaterThanOrEqual(result.seconds.search);
  });

  it('rejects with the code and sentence of an error', async () => {
    const { transport } = transportOf(
      engineOf([[{ type: 'error', code: 'bad-index', text: 'line 3: no vertex 9' }]]),
    );
    await expect(run(transport)).rejects.toMatchObject({
      name: 'JobError',
      code: 'bad-index',
      message: 'line 3: no vertex 9',
    });
  });

  it('cancels a running job and keeps its worker', async () => {
    const { transport, spawned } = transportOf(engineOf([[progress(0.5)]]));
    const control = new AbortController();
    const aborted = run(transport, {
      signal: control.signal,
      onEvent: () => control.abort(),
    });
    await expect(aborted).rejects.toMatchObject({ name: 'AbortError' });
    expect(spawned.count).toBe(1);
  });

  it('replaces a worker that does not answer a cancel', async () => {
    const { transport, spawned } = transportOf(engineOf([done]), (worker) => worker === 0);
    const control = new AbortController();
    const aborted = run(transport, { signal: control.signal });
    setImmediate(() => control.abort());
    const next = run(transport);
    await expect(aborted).rejects.toMatchObject({ name: 'AbortError' });
    await expect(next).resolves.toMatchObject({ parts: 1 });
    expect(spawned.count).toBe(2);
  });

  it('never starts a job that was aborted before', async () => {
    const { transport, spawned } = transportOf(engineOf([done]));
    await expect(run(transport, { signal: AbortSignal.abort() })).rejects.toThrow();
    expect(spawned.count).toBe(0);
  });

  it('replaces a worker that died', async () => {
    let alive = false;
    const spawned = { count: 0 };
    const transport = new Transport((listener) => {
      ++spawned.count;
      if (alive) return localPort(engineOf([done]), listener, false);
      alive = true;
      return {
        post: () => setImmediate(() => listener.onDeath('memory access out of bounds')),
        close: () => undefined,
      };
    });
    await expect(run(transport)).rejects.toMatchObject({
      code: 'engine-died',
      message: 'The engine stopped unexpectedly: memory access out of bounds',
    });
    await expect(run(transport)).resolves.toMatchObject({ parts: 1 });
    expect(spawned.count).toBe(2);
  });

  it('runs jobs in the order in which they were given', async () => {
    const { transport } = transportOf(engineOf([[progress(0.5)], done]));
    const order: number[] = [];
    await Promise.all([0, 1, 2].map((i) => run(transport).then(() => order.push(i))));
    expect(order).toEqual([0, 1, 2]);
  });

  it('tells the last of each kind before the end', async () => {
    const steps = Array.from({ length: 60 }, (_, i) => [progress(i / 60)]);
    const { transport } = transportOf(engineOf([...steps, done]));
    const heard: TimedEvent[] = [];
    await run(transport, { onEvent: (event) => heard.push(event) });
    expect(heard.length).toBeLessThan(60);
    expect(heard.slice(-2)).toMatchObject([{ type: 'stage', progress: 59 / 60 }, { type: 'done' }]);
  });
});
