/**
 * The studio's state: commands, and what the page shows after them; without a page and an engine. Longer than other
 * files: all of it is about one object.
 */
import { describe, expect, it, vi } from 'vitest';
import { UnusableChoice, type ChosenModel } from '../../web/app/model-file.js';
import { Store } from '../../web/app/store.js';
import type { Drawing } from '../../web/app/store-needs.js';
import { engineDied, JobError } from '../../web/core/job-error.js';
import { defaultSettings } from '../../web/api/written-options.js';
import { FakeSession } from './fake-session.js';

const settings = defaultSettings();
const fields = new Map<string, string>();
const file = (name: string): ChosenModel => ({
  name,
  files: [{ name, bytes: new Uint8Array() }],
});
const named = (part: number, text: string) => ({ kind: 'name', part, text }) as const;
const split = { kind: 'split', part: 2, into: 2 } as const;

/** Lets everything happen that waits for nothing. */
const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

/** A store with a fake session for each run. */
class Bench {
  readonly sessions: FakeSession[] = [];
  /** What drawing does; null: a later drawing was quicker. */
  drawing: () => Promise<Drawing | null> = () => Promise.resolve(this.drawn);
  readonly shown: boolean[] = [];
  readonly dropped = vi.fn();
  readonly life = new AbortController();
  readonly store = new Store({
    open: (files) => {
      this.sessions.push(new FakeSession(files[0]!.name));
      return Promise.resolve(this.session);
    },
    draw: () => this.drawing(),
    follow: () => undefined,
    onEvent: () => undefined,
    life: this.life.signal,
  });
  private readonly drawn: Drawing = {
    show: ({ isRenaming }) => this.shown.push(isRenaming),
    drop: this.dropped,
  };

  get session(): FakeSession {
    return this.sessions.at(-1)!;
  }

  get parts(): number | undefined {
    return this.store.run?.result.parts;
  }

  get names(): string[] {
    return this.store.run!.result.names.map(({ part, name }) => `${part} ${name}`);
  }

  /** Lets the present work end, when it has begun. */
  async goOn(error?: Error): Promise<void> {
    await settle();
    this.session.goOn(error);
    await settle();
  }

  async unfolded(name = 'ring.obj'): Promise<void> {
    await this.store.choose(Promise.resolve(file(name)));
    const ending = this.store.unfold(settings, fields);
    await this.goOn();
    expect(await ending).toMatchObject({ type: 'shown', isWhole: true });
  }
}

async function unfoldedBench(): Promise<Bench> {
  const bench = new Bench();
  await bench.unfolded();
  return bench;
}

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
