/** The studio's state: runs, and what the page shows after them; without a page and an engine. */
import { describe, expect, it, vi } from 'vitest';
import { engineDied, JobError } from '../../web/core/job-error.js';
import { Bench, fields, file, settings, settle, split, unfoldedBench } from './store-bench.js';

describe('a run', () => {
  it('chooses the model once it is read, and ends on the page', async () => {
    const { store, ...bench } = new Bench();
    expect(store.scene).toBe('welcome');
    expect(await store.unfold(settings, fields)).toEqual({ type: 'nothing' });
    await store.choose(Promise.resolve(file('ring.obj')));
    const ending = store.unfold(settings, fields);
    await settle();
    expect([store.work, store.scene, store.choice.opening]).toEqual(['running', 'empty', true]);
    bench.sessions[0]!.say({ type: 'model' });
    expect([store.scene, store.choice.opening]).toEqual(['pictures', false]);
    bench.sessions[0]!.goOn();
    expect(await ending).toMatchObject({ type: 'shown' });
    expect([store.work, store.scene]).toEqual(['idle', 'result']);
    expect(store.run?.model.name).toBe('ring.obj');
  });

  it('that is cancelled or fails leaves the run before, with its history', async () => {
    const bench = await unfoldedBench();
    const { store } = bench;
    const change = store.apply([split]);
    await bench.goOn();
    await change;
    await store.choose(Promise.resolve(file('other.obj')));
    for (const [error, ending] of [
      [null, { type: 'cancelled' }],
      [new JobError('no-faces', { what: 'nothing' }), { type: 'failed', cause: 'file' }],
      [new JobError('bad-option', { what: 'name-number' }), { type: 'failed', cause: 'job' }],
      [new JobError(engineDied, { reason: 'gone' }), { type: 'failed', cause: 'crash' }],
    ] as const) {
      const run = store.unfold(settings, fields);
      await settle();
      if (error) await bench.goOn(error);
      else store.cancel();
      expect(await run).toMatchObject(ending);
      expect([store.work, store.scene, bench.parts]).toEqual(['idle', 'result', 5]);
      expect(store.undoable).toEqual([split]);
    }
    // That it was a file that cannot be read is known of the second one.
    expect(store.choice.model?.name).toBe('ring.obj');
  });

  it('without a result leaves its pictures, or the welcome', async () => {
    const { store, sessions } = new Bench();
    await store.choose(Promise.resolve(file('ring.obj')));
    for (const [event, scene] of [
      [null, 'welcome'],
      [{ type: 'model' }, 'pictures'],
    ] as const) {
      const run = store.unfold(settings, fields);
      await settle();
      if (event) sessions.at(-1)!.say(event);
      store.cancel();
      expect(await run).toEqual({ type: 'cancelled' });
      expect(store.scene).toBe(scene);
    }
  });

  it('can be stopped once it has found a net, for what is there or for nothing', async () => {
    const bench = new Bench();
    const { store } = bench;
    const changes = vi.fn();
    store.on('work', changes);
    await store.choose(Promise.resolve(file('ring.obj')));
    for (const hasNets of [false, true]) {
      const run = store.unfold(settings, fields);
      await settle();
      store.stop();
      expect([store.work, store.canStop]).toEqual(['running', false]);
      changes.mockClear();
      bench.session.say({ type: 'net', part: 0, piece: 0 });
      expect([changes.mock.calls.length, store.canStop]).toEqual([1, true]);
      bench.session.isFruitful = hasNets;
      store.stop();
      expect(store.canStop).toBe(false);
      expect(await run).toMatchObject(
        hasNets ? { type: 'shown', isWhole: false } : { type: 'empty' },
      );
    }
    expect(store.scene).toBe('result');
  });

  it('that lacked parts lets its edits be stopped, too', async () => {
    const bench = await unfoldedBench();
    const { store } = bench;
    const change = async (): Promise<unknown> => {
      const changed = store.apply([split]);
      await settle();
      bench.session.say({ type: 'net', part: 0, piece: 0 });
      if (store.canStop) store.stop();
      else bench.session.goOn();
      return changed;
    };
    expect(store.canStop).toBe(false);
    // Nothing is missing: an edit is made or not.
    expect(await change()).toMatchObject({ type: 'shown' });
    expect(store.canStop).toBe(false);
    const { pieces } = store.run!.result;
    pieces.pop();
    bench.session.isFruitful = false;
    expect(await change()).toEqual({ type: 'empty' });
    bench.session.isFruitful = true;
    expect(await change()).toMatchObject({ type: 'shown' });
    expect(store.work).toBe('idle');
  });

  it('that is cancelled after it was stopped keeps nothing', async () => {
    const bench = await unfoldedBench();
    const { store } = bench;
    const { run: before } = store;
    const run = store.unfold(settings, fields);
    await settle();
    bench.session.say({ type: 'net', part: 0, piece: 0 });
    bench.session.isSlow = true;
    store.stop();
    store.cancel();
    expect(await run).toEqual({ type: 'cancelled' });
    expect(store.run).toBe(before);
  });

  it('takes over from the one before, and drops what that one draws', async () => {
    const bench = new Bench();
    const { store } = bench;
    await store.choose(Promise.resolve(file('ring.obj')));
    const first = store.unfold(settings, fields);
    const second = store.unfold(settings, fields);
    await bench.goOn();
    expect([(await first).type, (await second).type]).toEqual(['nothing', 'shown']);
    expect(bench.shown).toHaveLength(1);
  });

  it('whose sheets cannot be drawn leaves the run before', async () => {
    const bench = await unfoldedBench();
    vi.spyOn(console, 'error').mockImplementationOnce(() => undefined);
    bench.drawing = () => Promise.reject(new Error('no fonts'));
    await bench.store.choose(Promise.resolve(file('other.obj')));
    const run = bench.store.unfold(settings, fields);
    await bench.goOn();
    expect(await run).toMatchObject({ type: 'undrawn', run: { model: { name: 'other.obj' } } });
    expect(bench.store.run?.model.name).toBe('ring.obj');
  });
});

describe('the end of a studio', () => {
  it('ends the work, and nobody hears of it any more', async () => {
    const bench = await unfoldedBench();
    const heard = vi.fn();
    const change = bench.store.apply([split]).then(heard);
    await settle();
    bench.life.abort();
    await settle();
    expect(heard).not.toHaveBeenCalled();
    expect(bench.parts).toBe(4);
    void change;
  });
});
