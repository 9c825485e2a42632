/** A store without a page and an engine, for tests of the studio's state. */
import { expect, vi } from 'vitest';
import type { ChosenModel } from '../../web/app/model-file.js';
import { Store } from '../../web/app/store.js';
import type { Drawing } from '../../web/app/store-needs.js';
import { defaultSettings } from '../../web/api/written-options.js';
import { FakeSession } from './fake-session.js';

export const settings = defaultSettings();
export const fields = new Map<string, string>();
export const file = (name: string): ChosenModel => ({
  name,
  files: [{ name, bytes: new Uint8Array() }],
});
export const named = (part: number, text: string) => ({ kind: 'name', part, text }) as const;
export const split = { kind: 'split', part: 2, into: 2 } as const;

/** Lets everything happen that waits for nothing. */
export const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

/** A store with a fake session for each run. */
export class Bench {
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

export async function unfoldedBench(): Promise<Bench> {
  const bench = new Bench();
  await bench.unfolded();
  return bench;
}
