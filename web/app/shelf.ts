/** Where this browser keeps projects: IndexedDB, which is changed as a whole or not at all. */
import { openDB, type DBSchema, type IDBPDatabase, type IDBPTransaction } from 'idb';
import type { ModelFiles } from '../model/model-files.js';
import type { Project, SavedState } from '../project/project.js';
import type { Kept } from './model-file.js';

/** What a list of projects shows of one. */
export interface Card extends Kept {
  /** When it was saved last, in ms. */
  changed: number;
  /** Whether its run has not come to an end. */
  isPending: boolean;
  /** When it was taken off the list; it can be put back until the studio is opened again much later. */
  removed: number | null;
  /** A small picture as a data: address; empty if there is none. */
  picture: string;
}

/** A document without what is large and stays: its files, and its states by keys. */
interface KeptDocument extends Omit<Project, 'name' | 'files' | 'states'> {
  states: (string | null)[];
}

export interface SaveOrder {
  /** What was seen of it last; a new one has the revision 0. */
  kept: Kept;
  document: KeptDocument;
  /** Where they are not there already. */
  files: ModelFiles | null;
  /** Those that are not there already, by their keys. */
  states: ReadonlyMap<string, SavedState>;
  isPending: boolean;
  /** Null leaves the one that is there. */
  picture: string | null;
}

/** `other`: somebody else has saved it meanwhile; `gone`: or deleted it for good. Nothing was written then. */
export type SaveOutcome = { type: 'saved'; kept: Kept } | { type: 'other' } | { type: 'gone' };

interface Schema extends DBSchema {
  cards: { key: string; value: Card };
  documents: { key: string; value: KeptDocument };
  files: { key: string; value: ModelFiles };
  states: { key: [string, string]; value: SavedState };
}

const stores = ['cards', 'documents', 'files', 'states'] as const;
type Stores = (typeof stores)[number][];
type Change = IDBPTransaction<Schema, Stores, 'readwrite'>;

/** Ms for which what was taken off the list can be put back. */
const patience = 60 * 60 * 1000;

/** All keys of a project's states. */
const statesOf = (id: string): IDBKeyRange => IDBKeyRange.bound([id], [id, []]);

/** A name that no other project has, and that no other page makes up at the same time. */
export function newId(): string {
  const random = crypto.getRandomValues(new Uint32Array(2));
  return [Date.now(), ...random].map((number) => number.toString(36)).join('-');
}

export class Shelf {
  private readonly database: Promise<IDBPDatabase<Schema>>;

  constructor(name = 'foldwright') {
    this.database = openDB<Schema>(name, 1, {
      upgrade(database) {
        database.createObjectStore('cards', { keyPath: 'id' });
        for (const store of ['documents', 'files', 'states'] as const) {
          database.createObjectStore(store);
        }
      },
      // Another page wants to delete it, or to bring it up to date.
      blocking: (_, __, event) => (event.target as IDBDatabase).close(),
    });
  }

  /** What is on the list, the last one first. */
  async cards(): Promise<Card[]> {
    const cards = await (await this.database).getAll('cards');
    return cards.filter(({ removed }) => removed === null).sort((a, b) => b.changed - a.changed);
  }

  /** Deletes what was taken off the list so many ms ago, and cannot be put back any more; true if there was any. */
  tidy(age = patience): Promise<boolean> {
    return this.change(async (change) => {
      const last = Date.now() - age;
      const cards = await change.objectStore('cards').getAll();
      const old = cards.filter(({ removed }) => removed !== null && removed <= last);
      for (const { id } of old) await this.erase(change, id);
      return old.length > 0;
    });
  }

  /** Writes a project, unless there is more of it than the writer knows. */
  save(order: SaveOrder): Promise<SaveOutcome> {
    const { kept, document, files, states, isPending } = order;
    const { id, name } = kept;
    return this.change(async (change): Promise<SaveOutcome> => {
      const cards = change.objectStore('cards');
      const before = await cards.get(id);
      if (!before && kept.revision > 0) return { type: 'gone' };
      if ((before?.revision ?? 0) !== kept.revision || (!before && !files))
        return { type: 'other' };
      // Another page may have given it a name.
      const next: Kept = { id, name: before?.name ?? name, revision: kept.revision + 1 };
      const picture = order.picture ?? before?.picture ?? '';
      await cards.put({ ...next, changed: Date.now(), isPending, removed: null, picture });
      await change.objectStore('documents').put(document, id);
      if (files) await change.objectStore('files').put(files, id);
      await this.putStates(change, id, states, document.states);
      return { type: 'saved', kept: next };
    });
  }

  /** A project as it was saved last; null if it is not there any more. */
  async load(id: string): Promise<{ project: Project; kept: Kept } | null> {
    const change = (await this.database).transaction(stores);
    const [card, document, files] = await Promise.all([
      change.objectStore('cards').get(id),
      change.objectStore('documents').get(id),
      change.objectStore('files').get(id),
    ]);
    if (!card || !document || !files) return null;
    const { name, revision } = card;
    const store = change.objectStore('states');
    const states = await Promise.all(
      document.states.map(async (key) => (key === null ? null : store.get([id, key]))),
    );
    const found = states.map((state) => state ?? null);
    return { project: { ...document, name, files, states: found }, kept: { id, name, revision } };
  }

  /** Gives a project another name; pages that have it open need not mind. */
  rename(id: string, name: string): Promise<void> {
    return this.changeCard(id, (card) => ({ ...card, name }));
  }

  /** Takes a project off the list, or puts it back. */
  remove(id: string, isRemoved: boolean): Promise<void> {
    return this.changeCard(id, (card) => ({ ...card, removed: isRemoved ? Date.now() : null }));
  }

  /** Puts another one beside a project, with all that is in it. */
  copy(id: string, name: string): Promise<void> {
    return this.change(async (change) => {
      const [card, document, files] = await Promise.all([
        change.objectStore('cards').get(id),
        change.objectStore('documents').get(id),
        change.objectStore('files').get(id),
      ]);
      if (!card || !document || !files) return;
      const other = newId();
      await change.objectStore('cards').put({ ...card, id: other, name, changed: Date.now() });
      await change.objectStore('documents').put(document, other);
      await change.objectStore('files').put(files, other);
      const states = change.objectStore('states');
      for (const key of await states.getAllKeys(statesOf(id))) {
        await states.put((await states.get(key))!, [other, key[1]]);
      }
    });
  }

  private changeCard(id: string, to: (card: Card) => Card): Promise<void> {
    return this.change(async (change) => {
      const cards = change.objectStore('cards');
      const card = await cards.get(id);
      if (card) await cards.put(to(card));
    });
  }

  private async putStates(
    change: Change,
    id: string,
    states: ReadonlyMap<string, SavedState>,
    wanted: readonly (string | null)[],
  ): Promise<void> {
    const store = change.objectStore('states');
    for (const [key, state] of states) await store.put(state, [id, key]);
    for (const key of await store.getAllKeys(statesOf(id))) {
      if (!wanted.includes(key[1])) await store.delete(key);
    }
  }

  private async erase(change: Change, id: string): Promise<void> {
    await change.objectStore('cards').delete(id);
    await change.objectStore('documents').delete(id);
    await change.objectStore('files').delete(id);
    await change.objectStore('states').delete(statesOf(id));
  }

  /** All of it, or nothing; what is done is on the disk. */
  private async change<Value>(work: (change: Change) => Promise<Value>): Promise<Value> {
    const database = await this.database;
    const change = database.transaction([...stores] as Stores, 'readwrite', {
      durability: 'strict',
    });
    try {
      const value = await work(change);
      await change.done;
      return value;
    } catch (error) {
      // That it has ended is what is told anyway.
      change.done.catch(() => undefined);
      try {
        change.abort();
      } catch {
        // It has ended by itself: the device is full.
      }
      throw change.error ?? error;
    }
  }
}
