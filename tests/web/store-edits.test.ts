/** The studio's state: edits and names that come one after the other. */
import { describe, expect, it, vi } from 'vitest';
import { fields, named, settings, settle, split, unfoldedBench } from './store-bench.js';

describe('edits', () => {
  it('are made, taken back and made again, and choose what they touch', async () => {
    const bench = await unfoldedBench();
    const { store } = bench;
    const change = store.apply([split]);
    expect([store.work, store.busy]).toEqual(['editing', true]);
    store.toggle(0);
    expect(store.selection).toEqual([]);
    await bench.goOn();
    expect(await change).toMatchObject({ type: 'shown' });
    expect([bench.parts, store.selection, store.work]).toEqual([5, [1], 'idle']);
    expect([store.undoable, store.redoable]).toEqual([[split], null]);
    await store.undo();
    expect([bench.parts, store.selection]).toEqual([4, []]);
    expect([store.undoable, store.redoable]).toEqual([null, [split]]);
    expect(await store.undo()).toEqual({ type: 'nothing' });
    await store.redo();
    expect(bench.parts).toBe(5);
  });

  it('wait for no other edit that changes the numbers of parts', async () => {
    const bench = await unfoldedBench();
    const change = bench.store.apply([split]);
    for (const edit of [split, named(1, 'Head')]) {
      expect(await bench.store.apply([edit])).toEqual({ type: 'nothing' });
    }
    expect(await bench.store.undo()).toEqual({ type: 'nothing' });
    await bench.goOn();
    await change;
    expect(bench.parts).toBe(5);
  });

  it('that are cancelled or refused change nothing', async () => {
    const bench = await unfoldedBench();
    const { store } = bench;
    const change = store.apply([split]);
    await settle();
    store.cancel();
    expect(await change).toEqual({ type: 'cancelled' });
    const refused = store.apply([{ kind: 'unpin', piece: 1 }]);
    await bench.goOn();
    expect(await refused).toMatchObject({ type: 'refused', refusal: { code: 'bad-edit' } });
    expect([bench.parts, store.work, store.undoable]).toEqual([4, 'idle', null]);
  });

  it('that cannot be drawn are taken back, and can be made again', async () => {
    const bench = await unfoldedBench();
    const { store, drawing } = bench;
    vi.spyOn(console, 'error').mockImplementationOnce(() => undefined);
    bench.drawing = () => Promise.reject(new Error('no fonts'));
    const change = store.apply([split]);
    await bench.goOn();
    expect(await change).toMatchObject({ type: 'undrawn' });
    expect([bench.parts, bench.session.position, store.redoable]).toEqual([4, 0, [split]]);
    bench.drawing = drawing;
    await store.redo();
    expect(bench.parts).toBe(5);
  });

  it('end when a run begins', async () => {
    const bench = await unfoldedBench();
    const { store } = bench;
    const [session] = bench.sessions;
    const change = store.apply([split]);
    await settle();
    const run = store.unfold(settings, fields);
    await bench.goOn();
    expect([(await change).type, (await run).type]).toEqual(['cancelled', 'shown']);
    expect([bench.parts, session!.position, store.undoable]).toEqual([4, 0, null]);
  });
});

describe('names', () => {
  it('come one after the other without waiting for a drawing, and none is lost', async () => {
    const bench = await unfoldedBench();
    const { store, drawing } = bench;
    store.select([2]);
    // The first drawing is as slow as can be: the one after it is quicker.
    let finish: (drawn: null) => void = () => undefined;
    bench.drawing = () => new Promise((resolve) => (finish = resolve));
    const first = store.apply([named(1, 'Head')]);
    const second = store.apply([named(2, 'Tail')]);
    expect([store.work, store.busy]).toEqual(['editing', false]);
    expect(store.names.map(({ name }) => name)).toEqual(['Head', 'Tail']);
    await bench.goOn();
    bench.drawing = drawing;
    await bench.goOn();
    expect(await second).toMatchObject({ type: 'shown' });
    finish(null);
    expect(await first).toEqual({ type: 'nothing' });
    expect(bench.names).toEqual(['0 Head', '1 Tail']);
    expect([bench.shown.at(-1), store.selection]).toEqual([true, [2]]);
    await store.undo();
    expect(bench.names).toEqual(['0 Head']);
  });

  it('that are refused leave the others', async () => {
    const bench = await unfoldedBench();
    const good = bench.store.apply([named(1, 'Head')]);
    const bad = bench.store.apply([named(2, 'far too long for a part')]);
    await bench.goOn();
    await bench.goOn();
    expect([(await good).type, (await bad).type]).toEqual(['shown', 'refused']);
    expect([bench.names, bench.store.names]).toEqual([['0 Head'], [{ part: 0, name: 'Head' }]]);
  });

  it('that a part has already are no edits', async () => {
    const bench = await unfoldedBench();
    const first = bench.store.apply([named(1, 'Head')]);
    expect(await bench.store.apply([named(1, 'Head')])).toEqual({ type: 'nothing' });
    await bench.goOn();
    await first;
    expect(await bench.store.apply([named(2, '')])).toEqual({ type: 'nothing' });
    expect(bench.store.undoable).toEqual([named(1, 'Head')]);
  });

  it('are kept when a split or an undo follows at once', async () => {
    const bench = await unfoldedBench();
    const { store } = bench;
    const name = store.apply([named(1, 'Head')]);
    const undone = store.undo();
    await bench.goOn();
    await Promise.all([name, undone]);
    expect([bench.names, store.redoable]).toEqual([[], [named(1, 'Head')]]);
    const again = store.redo();
    await again;
    expect(bench.names).toEqual(['0 Head']);
    const next = store.apply([named(2, 'Tail')]);
    const change = store.apply([split]);
    await bench.goOn();
    await bench.goOn();
    await Promise.all([next, change]);
    expect(bench.parts).toBe(5);
    expect(store.undoable).toEqual([split]);
    await store.undo();
    expect(bench.names).toEqual(['0 Head', '1 Tail']);
  });
});
