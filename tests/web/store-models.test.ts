/** The studio's state: which model is chosen, looked at, and takes the place of another one. */
import { describe, expect, it } from 'vitest';
import { UnusableChoice } from '../../web/app/model-file.js';
import { JobError } from '../../web/core/job-error.js';
import {
  Bench,
  fields,
  file,
  named,
  settings,
  settle,
  split,
  unfoldedBench,
} from './store-bench.js';

describe('a look at the model', () => {
  const whole = {
    faces: 'off',
    up: 'guess',
    repair: 'on',
    fillHoles: 'off',
    inside: 'keep',
    crossing: 'keep',
  } as const;
  /** Of a model of so many triangles. */
  const found = (count: number) => ({
    model: { vertices: new Float32Array(9), faces: new Int32Array(3 * count) },
    componentOfFaces: new Int32Array(count),
    fileNets: 0,
  });

  it('fills the page where something is to decide, and what was read goes into the run', async () => {
    const bench = new Bench();
    const { store, sessions } = bench;
    await store.choose(Promise.resolve(file('bust.obj')));
    const look = store.inspect(whole);
    await settle();
    expect([store.work, store.scene, store.check]).toEqual(['running', 'empty', null]);
    bench.session.inspection = found(5000);
    await bench.goOn();
    expect(await look).toMatchObject({ type: 'inspected', check: { faces: 5000 } });
    expect([store.work, store.scene, store.choice.opening]).toEqual(['idle', 'check', false]);
    const run = store.unfold(settings, fields);
    await settle();
    expect(store.scene).toBe('check');
    await bench.goOn();
    expect(await run).toMatchObject({ type: 'shown' });
    expect([store.scene, sessions.length]).toEqual(['result', 1]);
    // The session of the page stays until there is another run to show.
    const again = store.unfold(settings, fields);
    await bench.goOn();
    await again;
    expect(sessions).toHaveLength(2);
  });

  it('can be left for the run before, and taken up again', async () => {
    const bench = await unfoldedBench();
    const { store } = bench;
    store.showCheck(true);
    expect(store.scene).toBe('result');
    await store.choose(Promise.resolve(file('bust.obj')));
    const look = store.inspect(whole);
    await settle();
    bench.session.inspection = found(5000);
    await bench.goOn();
    await look;
    for (const [isShown, scene] of [
      [true, 'check'],
      [false, 'result'],
      [true, 'check'],
    ] as const) {
      store.showCheck(isShown);
      expect(store.scene).toBe(scene);
    }
    expect([bench.parts, store.choice.model?.name]).toEqual([4, 'bust.obj']);
  });

  it('drops a file that is none, and gives way to a run', async () => {
    const bench = await unfoldedBench();
    const { store } = bench;
    await store.choose(Promise.resolve(file('letter.obj')));
    const look = store.inspect(whole);
    await bench.goOn(new JobError('no-faces', { what: 'nothing' }));
    expect(await look).toMatchObject({ type: 'failed', cause: 'file', code: 'no-faces' });
    expect([store.choice.model?.name, store.scene, store.check]).toEqual([
      'ring.obj',
      'result',
      null,
    ]);
    const slow = store.inspect(whole);
    await settle();
    const run = store.unfold(settings, fields);
    await bench.goOn();
    expect([(await slow).type, (await run).type]).toEqual(['nothing', 'shown']);
  });
});

describe('a choice', () => {
  it('that is slower than a later one is dropped, and one that is none changes nothing', async () => {
    const { store } = new Bench();
    const slow = store.choose(settle().then(() => file('slow.obj')));
    expect(await store.choose(Promise.resolve(file('quick.obj')))).toBe(true);
    expect(await slow).toBe(false);
    await expect(
      store.choose(Promise.reject(new UnusableChoice(({ choice }) => choice.noFile))),
    ).rejects.toThrow();
    expect(store.choice.model?.name).toBe('quick.obj');
  });
});

describe('a model that takes the place of another one', () => {
  /** A bench whose ring has two edits, of which a corrected one has taken over what fits. */
  async function replacedBench(): Promise<Bench> {
    const bench = await unfoldedBench();
    const { store } = bench;
    for (const edit of [split, named(1, 'Head')]) {
      const made = store.apply([edit]);
      await bench.goOn();
      await made;
    }
    await store.choose(Promise.resolve(file('ring2.obj')));
    const replacing = store.replace();
    // The run, and then each edit.
    for (let i = 0; i < 3; ++i) await bench.goOn();
    const { ending, carried } = await replacing;
    expect(ending).toMatchObject({ type: 'shown', isWhole: true });
    expect(carried).toEqual({ kept: 2, lost: [] });
    return bench;
  }

  it('is unfolded with the same options, gets the edits, and gives way by one undo', async () => {
    const { store } = await replacedBench();
    expect([store.run!.model.name, store.run!.result.parts]).toEqual(['ring2.obj', 5]);
    expect(store.choice.model?.name).toBe('ring2.obj');
    expect(store.undoable).toEqual([]);
    await store.undo();
    expect([store.run!.model.name, store.run!.result.parts]).toEqual(['ring.obj', 5]);
    expect(store.choice.model?.name).toBe('ring.obj');
    expect(store.undoable).toEqual([named(1, 'Head')]);
    expect(store.redoable).toEqual([]);
    await store.undo();
    expect(store.undoable).toEqual([split]);
    expect(store.redoable).toEqual([named(1, 'Head')]);
    await store.redo();
    await store.redo();
    expect([store.run!.model.name, store.choice.model?.name]).toEqual(['ring2.obj', 'ring2.obj']);
    expect(store.redoable).toBe(null);
  });

  it('is gone when the one before is edited', async () => {
    const bench = await replacedBench();
    const { store } = bench;
    await store.undo();
    const made = store.apply([named(2, 'Tail')]);
    await settle();
    bench.sessions[0]!.goOn();
    expect(await made).toMatchObject({ type: 'shown' });
    expect([store.run!.model.name, store.redoable]).toEqual(['ring.obj', null]);
    expect(bench.names).toEqual(['0 Head', '1 Tail']);
  });

  it('leaves all as it was when its run fails or is cancelled', async () => {
    const bench = await unfoldedBench();
    const { store } = bench;
    await store.choose(Promise.resolve(file('bad.obj')));
    const failing = store.replace();
    await bench.goOn(new JobError('no-faces', {}));
    expect((await failing).ending).toMatchObject({ type: 'failed', cause: 'file' });
    expect([store.run!.model.name, store.choice.model?.name]).toEqual(['ring.obj', 'ring.obj']);
    await store.choose(Promise.resolve(file('ring2.obj')));
    const left = store.replace();
    await settle();
    store.cancel();
    expect((await left).ending).toEqual({ type: 'cancelled' });
    expect([store.scene, store.run!.model.name]).toEqual(['result', 'ring.obj']);
  });
});
