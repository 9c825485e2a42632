import { describe, expect, it } from 'vitest';
import { EventThrottle } from '../../web/core/event-throttle.js';
import { GenerationFilter } from '../../web/core/generation-filter.js';
import { poolSize } from '../../web/core/pool-size.js';
import type { TimedEngineEvent } from '../../web/core/protocol.js';
import { StageClock } from '../../web/core/stage-clock.js';
import { nextBudget } from '../../web/core/step-budget.js';
import { TaskDispatcher } from '../../web/core/task-dispatcher.js';
import { buffersOf } from '../../web/core/transfer.js';
import type { EngineEvent } from '../../web/model/job.js';
import type { Stage } from '../../web/model/stages.js';

describe('nextBudget', () => {
  it('approaches ten milliseconds', () => {
    let budget = 1000;
    // A machine that does 250 units a millisecond.
    for (let i = 0; i < 10; ++i) budget = nextBudget(budget, budget / 250);
    expect(budget).toBe(2500);
  });

  it('is not misled by one long step or a clock that stands still', () => {
    expect(nextBudget(5000, 4000)).toBe(2500);
    expect(nextBudget(5000, 0)).toBe(10000);
    expect(nextBudget(100, 1e6)).toBe(100);
    expect(nextBudget(1e6, 0)).toBe(1e6);
  });
});

describe('EventThrottle', () => {
  const stage = (progress: number, name: Stage = 'learn'): TimedEngineEvent => {
    return { type: 'stage', stage: name, progress, seconds: 0 };
  };

  const generation = (number: number): TimedEngineEvent => {
    return { type: 'generation', part: 0, generation: number, best: 0, overlaps: 0, hyperbolic: 0 };
  };

  it('drops only what a later event of the batch tells as well', () => {
    const sent: TimedEngineEvent[][] = [];
    const throttle = new EventThrottle((events) => sent.push(events));
    const learned: TimedEngineEvent = { type: 'learned', runs: 10, of: 400 };
    const matrix: TimedEngineEvent = { ...learned, matrix: { size: 0, values: new Uint8Array() } };
    const net: TimedEngineEvent = { type: 'net', part: 0, piece: 0 };
    throttle.push(stage(0.1));
    throttle.release(0);
    const events = [stage(0.2), learned, matrix, net, stage(0.3), learned, matrix, stage(0.4)];
    for (const event of events) throttle.push(event);
    throttle.release(50);
    expect(sent).toEqual([[stage(0.1)]]);
    throttle.release(125);
    expect(sent[1]).toEqual([matrix, net, learned, matrix, stage(0.4)]);
    throttle.flush();
    expect(sent).toHaveLength(2);
  });

  it('tells every generation, in order', () => {
    const sent: TimedEngineEvent[] = [];
    const throttle = new EventThrottle((events) => sent.push(...events));
    const all = Array.from({ length: 500 }, (_, i) => generation(i + 1));
    all.forEach((event, i) => {
      throttle.push(event);
      throttle.release(i);
    });
    throttle.flush();
    expect(sent).toEqual(all);
  });

  it('tells at once that a stage begins', () => {
    const sent: TimedEngineEvent[] = [];
    const throttle = new EventThrottle((events) => sent.push(...events));
    throttle.push(stage(0.1));
    throttle.release(0);
    throttle.push(stage(0.5, 'cluster'));
    throttle.release(1);
    expect(sent).toEqual([stage(0.1), stage(0.5, 'cluster')]);
  });

  it('sends at most ten batches in any second, whatever happens', () => {
    const times: number[] = [];
    let now = 0;
    const throttle = new EventThrottle(() => times.push(now));
    for (; now < 5000; now += 10) {
      throttle.push(stage(0.5, now % 20 === 0 ? 'learn' : 'search'));
      throttle.push(generation(now));
      throttle.release(now);
    }
    for (const time of times) {
      expect(times.filter((other) => other >= time && other < time + 1000).length).toBeLessThan(11);
    }
    expect(times.length).toBeGreaterThanOrEqual(40);
  });
});

describe('GenerationFilter', () => {
  const generation = (number: number, part = 0): EngineEvent => {
    return { type: 'generation', part, generation: number, best: 0, overlaps: 1, hyperbolic: 0 };
  };

  it('swallows what a task that is run again tells again', () => {
    const filter = new GenerationFilter();
    const first = [generation(1), generation(2)];
    expect(filter.newOf(7, first)).toEqual(first);
    filter.restart(7);
    // The job counts on: 3 and 4 are 1 and 2 again.
    expect(filter.newOf(7, [generation(3)])).toEqual([]);
    expect(filter.newOf(7, [generation(4), generation(5)])).toEqual([generation(3)]);
    filter.restart(7);
    const again = [generation(6), generation(7), generation(8), generation(9)];
    expect(filter.newOf(7, again)).toEqual([generation(4)]);
  });

  it('numbers the other tasks of the part on, and leaves other parts alone', () => {
    const filter = new GenerationFilter();
    filter.newOf(7, [generation(1)]);
    filter.restart(7);
    filter.newOf(7, [generation(2)]);
    expect(filter.newOf(8, [generation(3), generation(1, 1)])).toEqual([
      generation(2),
      generation(1, 1),
    ]);
  });
});

describe('poolSize', () => {
  it('takes the cores, at most four, and two where memory is short', () => {
    expect([1, 2, 4, 16].map((cores) => poolSize(cores))).toEqual([1, 2, 4, 4]);
    expect([1, 2, 8].map((cores) => poolSize(cores, 4))).toEqual([1, 2, 2]);
    expect(poolSize(8, 8)).toBe(4);
  });
});

describe('TaskDispatcher', () => {
  const bytes = new Uint8Array(1);

  it('gives each helper one task at a time, and a surface only once', () => {
    const desk = new TaskDispatcher();
    for (const id of [0, 1, 2]) desk.add(id, 7, bytes);
    desk.join(5);
    expect(desk.assign()).toMatchObject({ helper: 5, task: { id: 0 }, needsSurface: true });
    expect(desk.assign()).toBeUndefined();
    expect(desk.isOut(5, 0)).toBe(true);
    desk.finish(5);
    expect(desk.assign()).toMatchObject({ helper: 5, task: { id: 1 }, needsSurface: false });
    expect(desk.takeOwn()).toMatchObject({ id: 2 });
    expect([desk.waitingCount, desk.outCount]).toEqual([0, 1]);
  });

  it('gives the task of a dead helper to the next one, and never to the conductor', () => {
    const desk = new TaskDispatcher();
    for (const id of [0, 1]) desk.add(id, 7, bytes);
    desk.join(5);
    desk.assign();
    desk.join(6);
    expect(desk.leave(5)).toMatchObject({ id: 0, deaths: 1 });
    expect(desk.takeOwn()).toMatchObject({ id: 1 });
    expect(desk.takeOwn()).toBeUndefined();
    expect(desk.assign()).toMatchObject({ helper: 6, task: { id: 0 }, needsSurface: true });
  });

  it('leaves nothing undone when there are no helpers any more', () => {
    const desk = new TaskDispatcher();
    desk.add(0, 7, bytes);
    desk.join(5);
    desk.assign();
    desk.leave(5);
    expect(desk.takeOwn()).toMatchObject({ id: 0 });
  });
});

describe('StageClock', () => {
  it('gives the time to the stage in which it passed', () => {
    const clock = new StageClock(1000);
    clock.spend(1500, 'read');
    clock.spend(2500, 'learn');
    clock.spend(4000);
    clock.spend(4250, 'paper');
    clock.fold(250);
    clock.fold(500);
    expect(clock.seconds()).toEqual({
      read: 0.5,
      learn: 2.5,
      cluster: 0,
      search: 0,
      fold: 0.75,
      compact: 0,
      paper: 0.25,
      total: 3.25,
    });
  });
});

describe('buffersOf', () => {
  it('finds every buffer once', () => {
    const shared = new Float64Array(4);
    const value = { a: shared, list: [{ b: new Int32Array(2) }, shared.subarray(1)], text: 'x' };
    expect(buffersOf(value)).toHaveLength(2);
  });
});
