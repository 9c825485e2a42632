/** Building steps that are done are remembered, for few results and never at any cost. */
import { describe, expect, it } from 'vitest';
import { DoneSteps, type Shelf } from '../../web/app/done-steps.js';

class FakeShelf implements Shelf {
  readonly texts = new Map<string, string>();

  getItem(name: string): string | null {
    return this.texts.get(name) ?? null;
  }

  setItem(name: string, text: string): void {
    this.texts.set(name, text);
  }
}

const stepsOf = (done: DoneSteps, hash: string): number[] => [...done.of(hash)];

describe('DoneSteps', () => {
  it('remembers each result by itself, for later visits', () => {
    const shelf = new FakeShelf();
    const done = new DoneSteps(() => shelf);
    done.set('a', 3, true);
    done.set('a', 0, true);
    done.set('b', 1, true);
    done.set('a', 3, false);
    const later = new DoneSteps(() => shelf);
    expect([stepsOf(later, 'a'), stepsOf(later, 'b'), stepsOf(later, 'c')]).toEqual([[0], [1], []]);
  });

  it('keeps no more than a bounded size: the results that were used last', () => {
    const shelf = new FakeShelf();
    const done = new DoneSteps(() => shelf);
    for (let i = 0; i < 500; ++i)
      for (const step of [0, 999, 5000]) done.set(`hash ${i}`, step, true);
    const size = [...shelf.texts.values()].reduce((sum, text) => sum + text.length, 0);
    expect(size).toBeLessThan(50_000);
    expect(stepsOf(done, 'hash 499')).toEqual([0, 999]);
    expect(stepsOf(done, 'hash 0')).toEqual([]);
  });

  it('forgets a result of which nothing is done any more', () => {
    const shelf = new FakeShelf();
    const done = new DoneSteps(() => shelf);
    done.set('a', 0, true);
    done.set('a', 0, false);
    expect([...shelf.texts.values()]).toEqual(['[]']);
  });

  it.each(['', 'nonsense', '{}', '[1, ["a"], ["a", 5], ["a", "xyz"]]'])(
    'takes %j for nothing that it has kept',
    (text) => {
      const shelf = new FakeShelf();
      new DoneSteps(() => shelf).set('b', 0, true);
      for (const name of shelf.texts.keys()) shelf.texts.set(name, text);
      const done = new DoneSteps(() => shelf);
      expect(stepsOf(done, 'a')).toEqual([]);
      done.set('a', 2, true);
      expect(stepsOf(done, 'a')).toEqual([2]);
    },
  );

  it('works where nothing is kept', () => {
    const done = new DoneSteps(() => {
      throw new Error('no storage here');
    });
    done.set('a', 1, true);
    expect(stepsOf(done, 'a')).toEqual([]);
  });
});
