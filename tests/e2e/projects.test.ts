/** Work that the browser keeps: after a reload, after a crash, in two tabs, and where nothing can be kept. */
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { numbers } from '../web/damage.js';
import { objText, wavyRing } from '../web/model-text.js';
import { projectErrors } from '../web/project-schema.js';
import { barriers } from './barriers.js';
import { resultIn, withElementPage } from './element-page.js';
import { kept, untilKept, type KeptWork } from './kept-work.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

const seed = 20261129;
/** Kills of a page at moments within its edits; more of them by hand. */
const kills = Number(process.env['KILLS'] ?? 4);

const ring = objText(wavyRing(12));

const press = (page: Page, name: string | RegExp): Promise<void> =>
  page.getByRole('button', { name }).click();

async function unfold(studio: StudioPage, name = 'ring.obj'): Promise<string> {
  await studio.page.fill('#parts', '4');
  await studio.choose(name, ring);
  return studio.resultOf(name.replace('.obj', ''));
}

/** The hash of the result that a change leads to. */
async function changed(studio: StudioPage, before: string): Promise<string> {
  await studio.page.locator(`#result:not([data-hash="${before}"])`).waitFor();
  return studio.resultOf('');
}

async function split(studio: StudioPage, part: number, before: string): Promise<string> {
  const { page } = studio;
  // What came of the split before is chosen still.
  const chosen = page.locator('.part[aria-pressed="true"]');
  while ((await chosen.count()) > 0) await chosen.first().click();
  await press(page, new RegExp(`^Part ${part}, piece`));
  await press(studio.page, 'Split this part');
  return changed(studio, before);
}

const isKept =
  (hash: string) =>
  ([first]: KeptWork[]): boolean =>
    first !== undefined && !first.isPending && first.hashes[first.cursor] === hash;

async function reload(studio: StudioPage): Promise<void> {
  await studio.page.reload();
  await studio.page.locator('.sample').first().waitFor();
  await studio.unfoldSettings();
}

test('work is there after a reload, with its history, in one press', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const first = await unfold(studio);
    const second = await split(studio, 2, first);
    const third = await split(studio, 1, second);
    await press(page, 'Undo: split of part 1');
    expect(await changed(studio, third)).toBe(second);
    await untilKept(page, (records) => isKept(second)(records) && records[0]!.steps === 2);
    const sheet = await page.locator('#sheets svg').first().innerHTML();

    await reload(studio);
    await expect.poll(() => page.locator('#recent-list li').count()).toBe(1);
    await page.fill('#parts', '7');
    await press(page, /^Go on with “ring”$/);
    expect(await studio.resultOf('ring')).toBe(second);
    expect(await page.locator('#sheets svg').first().innerHTML()).toBe(sheet);
    // The form says what the document says.
    expect(await page.locator('#parts').inputValue()).toBe('4');
    expect(await page.locator('.pending:visible').count()).toBe(0);
    await press(page, 'Redo: split of part 1');
    expect(await changed(studio, second)).toBe(third);
    await press(page, 'Undo: split of part 1');
    expect(await changed(studio, third)).toBe(second);
    await press(page, 'Undo: split of part 2');
    expect(await changed(studio, second)).toBe(first);
    await untilKept(page, isKept(first));
    expect(studio.complaints).toEqual([]);
  }));

test('a project file is written, and opens by drop on an open studio with its history', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const first = await unfold(studio);
    const second = await split(studio, 2, first);
    const file = await studio.download('Project, to go on later');
    expect(file.name).toBe('ring.foldwright');
    expect(projectErrors(file.bytes)).toEqual([]);

    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    await studio.drop([{ name: 'mine.foldwright', content: file.bytes }]);
    expect(await studio.resultOf('ring')).toBe(second);
    await press(page, 'Undo: split of part 2');
    expect(await changed(studio, second)).toBe(first);

    // Three works are kept: the first one, the cube, and the one of the file.
    expect(await untilKept(page, (all) => all.length === 3 && isKept(first)(all))).toHaveLength(3);
    const again = await studio.download('Project, to go on later');
    expect(projectErrors(again.bytes)).toEqual([]);
    expect(studio.complaints).toEqual([]);
  }));

test('a damaged project file leaves all as it is, with one sentence', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const hash = await unfold(studio);
    const house = readFileSync(new URL('../data/house.foldwright', import.meta.url));
    await studio.choose('house.foldwright', house.subarray(0, 400));
    expect(await studio.message()).toMatch(
      /^Nothing was unfolded\s+“?'house\.foldwright' is damaged/,
    );
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(hash);
    // Without its list of contents it opens all the same.
    await studio.choose('house.foldwright', house.subarray(0, house.length - 30));
    await studio.resultOf('house');
    expect(await page.locator('#message').isHidden()).toBe(true);
    await page.getByRole('button', { name: /^Undo: / }).waitFor();
    expect(studio.complaints).toEqual([]);
  }));

test('work is renamed, copied, deleted and put back on the start screen', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const hash = await unfold(studio);
    await untilKept(page, isKept(hash));
    await reload(studio);
    await expect.poll(() => page.locator('#recent-list img').count()).toBe(1);
    expect(await barriers(page)).toEqual([]);
    await press(page, 'Rename “ring”');
    await page.keyboard.type('My crown');
    await page.keyboard.press('Enter');
    await page.getByText('My crown', { exact: true }).waitFor();
    await press(page, 'Copy “My crown”');
    await page.getByText('Copy of My crown', { exact: true }).waitFor();
    await press(page, 'Delete “My crown”');
    await page.getByText('“My crown” was deleted.').waitFor();
    await expect.poll(() => page.locator('#recent-list li').count()).toBe(1);
    await page.keyboard.press('Enter');
    await page.locator('#recent-list li').nth(1).waitFor();
    await press(page, 'Delete “Copy of My crown”');
    await page.getByText('“Copy of My crown” was deleted.').waitFor();
    await reload(studio);
    await expect.poll(() => page.locator('#recent-list li').count()).toBe(1);
    await press(page, /^Go on with “My crown”$/);
    expect(await studio.resultOf('ring')).toBe(hash);
    expect((await studio.download('Project, to go on later')).name).toBe('My crown.foldwright');
    expect(studio.complaints).toEqual([]);
  }));

test('two tabs on one project: both keep their work', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const first = await unfold(studio);
    const one = await split(studio, 2, first);
    await untilKept(page, isKept(one));
    const other = await studio.anotherTab();
    await press(other.page, /^Go on with “ring”$/);
    expect(await other.resultOf('ring')).toBe(one);
    // Who only looks changes nothing.
    await page.waitForTimeout(700);
    expect(await kept(page)).toHaveLength(1);

    const two = await split(studio, 1, one);
    await untilKept(page, isKept(two));
    const three = await split(other, 3, one);
    await untilKept(page, (all) => all.length === 2 && isKept(three)(all));
    expect(await other.message()).toMatch(/changed on another page[\s\S]*“ring \(2\)”/);
    const all = await kept(page);
    expect(all.map(({ name, hashes, cursor }) => [name, hashes[cursor]])).toEqual([
      ['ring (2)', three],
      ['ring', two],
    ]);
    // Both go on with their own.
    const four = await split(studio, 1, two);
    await untilKept(page, isKept(four));
    expect(await kept(page)).toHaveLength(2);
    expect([...studio.complaints, ...other.complaints]).toEqual([]);
  }));

/** Deletes all works for good by other means than the studio's, as another tab does an hour after it took them off the list. */
function purge(page: Page): Promise<void> {
  return page.evaluate(async () => {
    const opening = indexedDB.open('foldwright');
    const database = await new Promise<IDBDatabase>((done) => {
      opening.onsuccess = () => done(opening.result);
    });
    const stores = [...database.objectStoreNames];
    const change = database.transaction(stores, 'readwrite');
    for (const store of stores) change.objectStore(store).clear();
    await new Promise((done) => (change.oncomplete = done));
    database.close();
  });
}

test('work that another tab has deleted for good is said to be, and kept again in one press', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const first = await unfold(studio);
    await untilKept(page, isKept(first));
    await purge(page);
    const second = await split(studio, 2, first);
    expect(await studio.message()).toMatch(/^“ring” was deleted on another page\s/);
    expect(await kept(page)).toEqual([]);
    // Whoever does not answer is asked again with the next change.
    const third = await split(studio, 1, second);
    expect(await studio.message()).toMatch(/^“ring” was deleted on another page\s/);
    await press(page, 'Keep it');
    const [record] = await untilKept(page, isKept(third));
    expect(record).toMatchObject({ name: 'ring', hashes: [first, second, third] });
    expect(await page.locator('#message').isHidden()).toBe(true);
    await reload(studio);
    await press(page, /^Go on with “ring”$/);
    expect(await studio.resultOf('ring')).toBe(third);
    expect(studio.complaints).toEqual([]);
  }));

test('a run that went on when the tab was closed is offered again', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#seed', '5');
    await page.fill('#parts', '3');
    await page.fill('#runs', '60000');
    await studio.choose('ring.obj', objText(wavyRing(30)));
    await untilKept(page, ([first]) => first?.isPending === true);
    const again = await studio.crash();
    await press(again.page, /^Unfold “ring” again$/);
    await again.page.locator('#cancel').waitFor();
    await again.page.locator('#cancel').click();
    expect(await again.page.locator('#chosen').innerText()).toContain('ring');
    // It is still there: nothing has come of it.
    expect((await kept(again.page))[0]).toMatchObject({ name: 'ring', isPending: true, cursor: 0 });
  }));

/** Remembers in the page when its result has changed. */
function watchHash(page: Page): Promise<void> {
  return page.locator('#result').evaluate((result: HTMLElement) => {
    result.dataset['since'] = String(performance.now());
    const note = (): void => void (result.dataset['since'] = String(performance.now()));
    new MutationObserver(note).observe(result, { attributeFilter: ['data-hash'] });
  });
}

/** The result on the page, and for how many ms it has been there. */
function lastHash(page: Page): Promise<{ hash: string; age: number }> {
  return page.locator('#result').evaluate(({ dataset }: HTMLElement) => {
    return { hash: dataset['hash'] ?? '', age: performance.now() - Number(dataset['since']) };
  });
}

test('a page that is killed within its edits loses nothing that was a second old', () =>
  withStudio(async (studio) => {
    let page = studio;
    const below = numbers(seed);
    let hash = await unfold(page);
    await untilKept(page.page, isKept(hash));
    for (let kill = 0; kill < kills; ++kill) {
      const before = hash;
      await watchHash(page.page);
      // An edit that may be made, drawn or saved when the page dies.
      await press(page.page, /^Part 1, piece/);
      await press(page.page, 'Split this part');
      await page.page.waitForTimeout(below(1800));
      const last = await lastHash(page.page);
      page = await page.crash();
      const [record] = await kept(page.page);
      await press(page.page, /^Go on with “ring”$/);
      hash = await page.resultOf('ring');
      expect(hash).toBe(record!.hashes[record!.cursor]);
      // What was there for a second is there again; what is newer, or else what was before.
      const possible = last.age > 1000 ? [last.hash] : [before, last.hash];
      expect(possible, `kill ${kill}, after ${last.age} ms`).toContain(hash);
      while (await page.page.locator('#undo:visible').count()) {
        await page.page.locator('#undo').click();
        hash = await changed(page, hash);
      }
      await untilKept(page.page, isKept(hash));
    }
  }));

test.each([
  ['that has no database', 'Object.defineProperty(self, "indexedDB", { value: undefined });'],
  [
    'that refuses to open one',
    `IDBFactory.prototype.open = () => { throw new DOMException('denied', 'SecurityError'); };`,
  ],
])('a browser %s says so beforehand, and all else works', (_, script) =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await page.getByText('This browser keeps nothing for this page').waitFor();
      const hash = await unfold(studio);
      expect(await studio.message()).toMatch(/Your work is not kept/);
      await split(studio, 2, hash);
      const { bytes } = await studio.download('Project, to go on later');
      expect(projectErrors(bytes)).toEqual([]);
      expect(studio.complaints).toEqual([]);
    },
    { workerScript: script, workers: /\/project-worker-[^/]*\.js$/ },
  ),
);

test.each([
  ['', 0],
  ['autosave', 1],
])('an element of another page with the attribute “%s” keeps %i works', (attribute, count) =>
  withElementPage(
    {
      markup: `<foldwright-studio src="ring.obj" parts="4" ${attribute}></foldwright-studio>`,
      files: { 'shop/ring.obj': ring },
    },
    async ({ page, complaints }) => {
      await resultIn(page.locator('foldwright-studio'), 'ring');
      await page.waitForTimeout(1000);
      const names = await page.evaluate(async () => (await indexedDB.databases()).length);
      expect(names).toBe(count);
      if (count > 0) expect(await kept(page)).toHaveLength(count);
      expect(await page.evaluate(() => localStorage.length)).toBe(0);
      expect(complaints).toEqual([]);
    },
  ),
);

test('little room is told beforehand', () =>
  withStudio(
    async ({ page, complaints }) => {
      await page.getByText('There is little room left on this device').waitFor();
      expect(complaints).toEqual([]);
    },
    {
      workers: /\/project-worker-[^/]*\.js$/,
      workerScript: 'StorageManager.prototype.estimate = async () => ({ quota: 9e6, usage: 8e6 });',
    },
  ));

test('the paper is a habit of the person, and no matter of a project', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.locator('#paper').focus();
    await page.keyboard.type('Letter');
    await reload(studio);
    const paper = page.locator('#paper');
    expect(await paper.inputValue()).toBe('Letter');
    const house = readFileSync(new URL('../data/house.foldwright', import.meta.url));
    await studio.choose('house.foldwright', house);
    await studio.resultOf('house');
    expect(await paper.inputValue()).toBe('A4');
    await reload(studio);
    expect(await paper.inputValue()).toBe('Letter');
    expect(studio.complaints).toEqual([]);
  }));

test('a full device is told, and the project file still holds all', () =>
  withStudio(
    async (studio) => {
      const hash = await unfold(studio);
      expect(await studio.message()).toMatch(/not kept[\s\S]*no room left/);
      await split(studio, 2, hash);
      const { bytes } = await studio.download('Project, to go on later');
      expect(projectErrors(bytes)).toEqual([]);
      expect(studio.complaints).toEqual([]);
    },
    {
      workers: /\/project-worker-[^/]*\.js$/,
      workerScript: `IDBObjectStore.prototype.put = function () {
        throw new DOMException('full', 'QuotaExceededError');
      };`,
    },
  ));
