/** Many viewers on one page: what they share, and what is left of them. */
import type { Page, Worker } from 'playwright-core';
import { expect, test } from 'vitest';
import { poolSize } from '../../web/core/pool-size.js';
import { contextsIn, heldIn, resourcesOf, watchResources } from './page-resources.js';
import { ring, unfoldedRing } from './unfolded-ring.js';
import { withViewerPage, type ViewerPage } from './viewer-page.js';

const count = 10;

/** A blank canvas has next to no bytes. */
const blank = 1500;

const all = Array.from({ length: count }, (_, i) => i);

/**
 * Adds viewers of the ring by their numbers, of different sizes, each folded to another time: no two of them look alike.
 * The policy of the page lets no markup have styles.
 */
function addViewers(page: Page, numbers: readonly number[] = all): Promise<void> {
  return page.evaluate((wanted) => {
    for (const number of wanted) {
      const viewer = document.createElement('foldwright-viewer');
      viewer.style.cssText = `float: left; min-height: 0; margin: 4px;
        width: ${200 + 20 * (number % 3)}px; height: ${180 + 30 * (number % 4)}px`;
      Object.assign(viewer, { src: 'ring.fold', loading: 'eager', fold: number / 10 });
      document.body.append(viewer);
    }
  }, numbers);
}

const removeViewers = (page: Page, first = 0): Promise<void> =>
  page.evaluate((from) => {
    const viewers = [...document.querySelectorAll('foldwright-viewer')];
    for (const viewer of viewers.slice(from)) viewer.remove();
  }, first);

/** Pictures of the first viewers, once each shows its model. */
async function picturesOf(page: Page, wanted = count): Promise<Buffer[]> {
  const pictures: Buffer[] = [];
  const viewers = await page.locator('foldwright-viewer').all();
  for (const viewer of viewers.slice(0, wanted)) {
    // Attempts that have failed leave theirs until one succeeds.
    const canvas = viewer.locator('canvas').last();
    let picture = await canvas.screenshot();
    while (picture.length < blank) picture = await canvas.screenshot();
    pictures.push(picture);
  }
  return pictures;
}

/** The worker that draws: there is no other one while nothing is unfolded. */
function onlyWorker(page: Page): Worker {
  expect(page.workers()).toHaveLength(1);
  return page.workers()[0]!;
}

/** Opens a page that is watched, with viewers that may be added to it. */
async function withCatalogue(
  work: (opened: ViewerPage) => Promise<void>,
  script = '',
): Promise<void> {
  const { fold } = await unfoldedRing();
  const prepare = async (page: Page): Promise<void> => {
    await watchResources(page);
    await page.addInitScript(script);
  };
  await withViewerPage('<h1>A catalogue</h1>', { 'ring.fold': fold, 'ring.obj': ring }, work, {
    prepare,
  });
}

function foldAll(page: Page, time: number): Promise<void> {
  return page.evaluate(async (to) => {
    const viewers = [...document.querySelectorAll('foldwright-viewer')];
    await Promise.all(viewers.map((viewer) => viewer.foldTo(to)));
  }, time);
}

/** What browser and library say when pictures are copied in software, and when a context ends. */
const ofGraphics = /GPU stall due to ReadPixels|Context Lost/;

const differing = (ones: readonly Buffer[], others: readonly Buffer[]): number =>
  ones.filter((picture, i) => !picture.equals(others[i]!)).length;

test('ten viewers are drawn by one worker with one WebGL context, each as if it were alone', () =>
  withCatalogue(async ({ page, complaints }) => {
    await addViewers(page, [7]);
    const [alone] = await picturesOf(page);
    const worker = onlyWorker(page);
    const ofOne = await heldIn(worker);
    await removeViewers(page);
    await expect.poll(() => page.workers().length).toBe(0);

    await addViewers(page);
    const together = await picturesOf(page);
    expect(new Set(together.map((picture) => picture.toString('base64'))).size).toBe(count);
    expect(together[7]!.equals(alone!)).toBe(true);
    const shared = onlyWorker(page);
    expect([await contextsIn(shared), await contextsIn(page)]).toEqual([[false], []]);
    await page.screenshot({ path: 'build/screenshots/viewers-ten.png' });

    // Whoever goes takes along what it had of the graphics card.
    const ofTen = await heldIn(shared);
    await removeViewers(page, 1);
    await expect.poll(async () => (await heldIn(shared))['Buffer']).toBe(ofOne['Buffer']);
    expect(ofTen['Buffer']).toBe(count * ofOne['Buffer']!);
    expect(await heldIn(shared)).toEqual(ofOne);
    expect(complaints).toEqual([]);
  }));

test('a context that is lost comes back with all viewers', () =>
  withCatalogue(async ({ page, complaints }) => {
    await addViewers(page);
    const before = await picturesOf(page);
    const worker = onlyWorker(page);
    await worker.evaluate(() => {
      const [context] = globalThis.noted.contexts;
      globalThis.lossOf = context!.getExtension('WEBGL_lose_context')!;
      globalThis.lossOf.loseContext();
    });
    await expect.poll(() => contextsIn(worker)).toEqual([true]);
    // What was drawn last is still there, and nothing new.
    await foldAll(page, 0.55);
    expect(differing(before, await picturesOf(page))).toBe(0);
    await worker.evaluate(() => globalThis.lossOf.restoreContext());
    await expect.poll(async () => differing(before, await picturesOf(page))).toBe(count);
    expect(complaints).toEqual([]);
  }));

test('viewers go on when the process of the graphics card has died', () =>
  withCatalogue(async ({ page, complaints }) => {
    await addViewers(page);
    const before = await picturesOf(page);
    const worker = onlyWorker(page);
    const devtools = await page.context().browser()!.newBrowserCDPSession();
    await devtools.send('Browser.crashGpuProcess');
    await expect.poll(() => contextsIn(worker)).toEqual([true]);
    await expect.poll(() => contextsIn(worker)).toEqual([false]);
    await foldAll(page, 0.55);
    await expect.poll(async () => differing(before, await picturesOf(page))).toBe(count);
    expect(complaints).toEqual([]);
  }));

test('where workers cannot draw, ten viewers share a context of the page', () =>
  withCatalogue(async ({ page, complaints }) => {
    for (const isLost of [[false], [true, false]]) {
      await addViewers(page);
      const pictures = await picturesOf(page);
      expect(new Set(pictures.map((picture) => picture.toString('base64'))).size).toBe(count);
      expect(page.workers()).toHaveLength(0);
      expect(await contextsIn(page)).toEqual(isLost);
      await removeViewers(page);
      await expect.poll(() => contextsIn(page)).toEqual(isLost.map(() => true));
    }
    expect(complaints.filter((words) => !ofGraphics.test(words))).toEqual([]);
  }, 'delete HTMLCanvasElement.prototype.transferControlToOffscreen;'));

test('a viewer that cannot be drawn leaves all others as they are', () =>
  withCatalogue(async ({ page }) => {
    await addViewers(page, [1, 3]);
    const before = await picturesOf(page);
    await page.evaluate(() => {
      type Post = (this: MessagePort, message: { type?: string; pieces?: unknown }) => void;
      const own = Reflect.get(MessagePort.prototype, 'postMessage') as Post;
      MessagePort.prototype.postMessage = function (message: Parameters<Post>[0]) {
        if (message.type === 'folding') message.pieces = [{}];
        own.call(this, message);
      };
    });
    await addViewers(page, [5]);
    const broken = page.locator('foldwright-viewer').last();
    await expect.poll(() => broken.getByRole('status').innerText()).not.toBe('');
    await page.evaluate(() => document.querySelector('foldwright-viewer')!.foldTo(0.8));
    await expect.poll(async () => differing(before, await picturesOf(page, 2))).toBe(1);
    expect(page.workers()).toHaveLength(1);
  }));

/** Adds viewers that unfold the ring, all at once. */
function unfoldSome(page: Page, wanted: number): Promise<void> {
  return page.evaluate(async (number) => {
    const viewers = Array.from({ length: number }, () =>
      document.createElement('foldwright-viewer'),
    );
    for (const viewer of viewers) {
      Object.assign(viewer, { src: 'ring.obj', parts: '3', seed: '2', controls: true });
      document.body.append(viewer);
    }
    await Promise.all(viewers.map((viewer) => viewer.unfold()));
  }, wanted);
}

/** As many workers of the engine as there are for one page. */
async function poolSizeOf(page: Page): Promise<number> {
  const [cores, memory] = await page.evaluate(() => {
    const { hardwareConcurrency, deviceMemory } = navigator as Navigator & {
      deviceMemory?: number;
    };
    return [hardwareConcurrency, deviceMemory] as const;
  });
  return poolSize(cores, memory);
}

test('ten viewers that were shown, moved and removed leave nothing behind, twice', () =>
  withCatalogue(async ({ page, host, complaints }) => {
    const devtools = await page.context().newCDPSession(page);
    // What drives the page listens itself from its first look on.
    await page.locator('h1').screenshot();
    const before = await resourcesOf(page, devtools);
    const folded = all.slice(0, 7);
    for (let round = 0; round < 2; ++round) {
      await addViewers(page, folded);
      await unfoldSome(page, count - folded.length);
      await picturesOf(page);
      // Beside the worker that draws.
      expect(page.workers().length - 1).toBeLessThanOrEqual(await poolSizeOf(page));
      expect(await resourcesOf(page, devtools)).toMatchObject({ elements: count });

      await page.evaluate(() => {
        for (const viewer of document.querySelectorAll('foldwright-viewer')) {
          document.body.prepend(viewer);
        }
      });
      await foldAll(page, 0.5);
      await picturesOf(page);
      await removeViewers(page);
      await expect.poll(() => page.workers().length).toBe(0);
      // Relays to workers of another origin stay: one for each script.
      const { blobs, ...others } = await resourcesOf(page, devtools);
      expect(blobs.map((text) => text.replace(host, '')).sort()).toEqual([
        expect.stringMatching(/^import "assets\/model-worker-[^/]+\.js";$/),
        expect.stringMatching(/^import "assets\/worker-[^/]+\.js";$/),
      ]);
      expect({ ...others, blobs: [] }).toEqual(before);
    }
    expect(complaints).toEqual([]);
  }));
