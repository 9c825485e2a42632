import { describe, expect, it } from 'vitest';
import { EventThrottle } from '../../web/core/event-throttle.js';
import type { TimedEvent } from '../../web/core/protocol.js';
import { StageClock } from '../../web/core/stage-clock.js';
import { nextBudget } from '../../web/core/step-budget.js';
import { buffersOf } from '../../web/core/transfer.js';
import type { Stage } from '../../web/model/job.js';

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
  const stage = (progress: number, name: Stage = 'learn'): TimedEvent => {
    return { type: 'stage', stage: name, progress, seconds: 0 };
  };

  it('keeps the latest of each kind and lets everything else pass', () => {
    const sent: TimedEvent[] = [];
    const throttle = new EventThrottle((event) => sent.push(event));
    throttle.push(stage(0.1));
    throttle.release(0);
    throttle.push(stage(0.2));
    throttle.push(stage(0.3));
    throttle.push({ type: 'learned', runs: 10, of: 400 });
    throttle.release(50);
    throttle.push({ type: 'net', part: 0, piece: 0 });
    expect(sent).toEqual([stage(0.1), { type: 'net', part: 0, piece: 0 }]);
    throttle.release(125);
    expect(sent.at(-1)).toEqual(stage(0.3));
    throttle.flush();
    expect(sent.at(-1)).toEqual({ type: 'learned', runs: 10, of: 400 });
    throttle.flush();
    expect(sent).toHaveLength(4);
  });

  it('tells at once that a stage begins', () => {
    const sent: TimedEvent[] = [];
    const throttle = new EventThrottle((event) => sent.push(event));
    throttle.push(stage(0.1));
    throttle.release(0);
    throttle.push(stage(0.5, 'cluster'));
    throttle.release(1);
    expect(sent).toEqual([stage(0.1), stage(0.5, 'cluster')]);
  });

  it('sends at most ten in any second, whatever happens', () => {
    const times: number[] = [];
    let now = 0;
    const throttle = new EventThrottle(() => times.push(now));
    for (; now < 5000; now += 10) {
      throttle.push(stage(0.5, now % 20 === 0 ? 'learn' : 'search'));
      throttle.push({ type: 'learned', runs: 10, of: 400 });
      throttle.release(now);
    }
    for (const time of times) {
      expect(times.filter((other) => other >= time && other < time + 1000).length).toBeLessThan(11);
    }
    expect(times.length).toBeGreaterThanOrEqual(40);
  });
});

describe('StageClock', () => {
  it('gives the time to the stage in which it passed', () => {
    const clock = new StageClock(1000);
    clock.spend(1500, 'read');
    clock.spend(2500, 'learn');
    clock.spend(4000);
    clock.spend(4250, 'paper');
    expect(clock.seconds()).toEqual({
      read: 0.5,
      learn: 2.5,
      cluster: 0,
      search: 0,
      fold: 0,
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
