/** The work that the studio has kept, read from the browser's database by other means than its own. */

/** As far as it is asked here; pages of all drivers of browsers are such. */
interface Page {
  evaluate<Result>(body: () => Promise<Result>): Promise<Result>;
}

/** A project as it lies in the browser's database. */
export interface KeptWork {
  name: string;
  isPending: boolean;
  steps: number;
  cursor: number;
  hashes: (string | null)[];
}

/** What the browser keeps now, the last one first. */
export async function kept(page: Page): Promise<KeptWork[]> {
  return page.evaluate(async () => {
    const opening = indexedDB.open('foldwright');
    const database = await new Promise<IDBDatabase>((resolve, reject) => {
      opening.onsuccess = () => resolve(opening.result);
      opening.onerror = () => reject(new Error('no database'));
    });
    const stores = ['cards', 'documents', 'states'];
    if (!database.objectStoreNames.contains('cards')) {
      database.close();
      return [];
    }
    const change = database.transaction(stores);
    const get = <Value>(request: IDBRequest<Value>): Promise<Value> =>
      new Promise((resolve) => (request.onsuccess = () => resolve(request.result)));
    interface Card {
      id: string;
      name: string;
      changed: number;
      isPending: boolean;
      removed: number | null;
    }
    interface Document {
      steps: unknown[];
      cursor: number;
      states: (string | null)[];
    }
    const cards = (await get(change.objectStore('cards').getAll())) as Card[];
    const records: KeptWork[] = [];
    for (const card of cards.sort((a, b) => b.changed - a.changed)) {
      if (card.removed !== null) continue;
      const document = (await get(change.objectStore('documents').get(card.id))) as Document;
      const hashes: KeptWork['hashes'] = [];
      for (const key of document.states) {
        const found = key === null ? null : change.objectStore('states').get([card.id, key]);
        const state = found && ((await get(found)) as { hash: string } | undefined);
        hashes.push(state?.hash ?? null);
      }
      const { name, isPending } = card;
      const { steps, cursor } = document;
      records.push({ name, isPending, steps: steps.length, cursor, hashes });
    }
    database.close();
    return records;
  });
}

/** Waits until the browser has kept what is asked for, which takes less than a second. */
export async function untilKept(
  page: Page,
  isThere: (records: KeptWork[]) => boolean,
): Promise<KeptWork[]> {
  const last = Date.now() + 5000;
  for (;;) {
    const records = await kept(page);
    if (isThere(records)) return records;
    if (Date.now() > last) throw new Error(`It is not kept: ${JSON.stringify(records)}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}
