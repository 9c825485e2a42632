/** After one visit everything works without a server, and an open page survives a new deployment. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { Deployment } from './deployment.js';
import { sharedBrowser } from './shared-browser.js';
import { StudioPage } from './studio-page.js';

const formats = [
  'PDF',
  'SVG',
  'Pictures (PNG)',
  'Machine (DXF)',
  'FOLD',
  'Folding animation (GLB)',
];
const nextBuild = 'The next build';

async function withDeployment(
  work: (studio: StudioPage, deployment: Deployment) => Promise<void>,
  missing?: string,
): Promise<void> {
  const deployment = await Deployment.start();
  try {
    if (missing) await deployment.lose(missing);
    const studio = await StudioPage.open(
      deployment.address,
      { serviceWorkers: 'allow' },
      await sharedBrowser(),
    );
    try {
      await work(studio, deployment);
    } finally {
      await studio.close();
    }
  } finally {
    await deployment.remove();
  }
}

/** First bytes of a download in every format. */
async function downloads(studio: StudioPage): Promise<string[]> {
  const starts: string[] = [];
  for (const format of formats) {
    const { bytes } = await studio.download(format);
    starts.push(bytes.subarray(0, 5).toString('latin1'));
  }
  return starts;
}

/** Several sheets come as a zip file. */
const realFiles = [/^%PDF-/, /^(<\?xml|PK)/, /^(\x89PNG|PK)/, /^(0\nSEC|PK)/, /^\{/, /^glTF/].map(
  (start): unknown => expect.stringMatching(start),
);
const patience = { timeout: 20_000 };

/** Whether a new build is kept and waits for its turn; looks for one first. */
function nextBuildWaits({ page }: StudioPage): Promise<void> {
  return page.evaluate(async () => {
    const registration = (await navigator.serviceWorker.getRegistration())!;
    await registration.update();
    while (!registration.waiting) await new Promise((done) => setTimeout(done, 50));
  });
}

/** Loads the page anew, waits a while for the next build to take over, and says whose page it is. */
async function buildAfterReload({ page }: StudioPage): Promise<string> {
  await page.reload();
  const isNext = (build: string): boolean =>
    document.querySelector<HTMLMetaElement>('meta[name="description"]')!.content === build;
  await page.waitForFunction(isNext, nextBuild, { timeout: 10_000 }).catch(() => undefined);
  return buildOf(page);
}

/** By its description, which no script changes. */
function buildOf(page: Page): Promise<string> {
  return page
    .locator('meta[name="description"]')
    .evaluate((element: HTMLMetaElement) => element.content);
}

const cacheCount = ({ page }: StudioPage): Promise<number> =>
  page.evaluate(() => caches.keys().then(({ length }) => length));

test('after one visit it runs and writes all files without a server', () =>
  withDeployment(async (studio, deployment) => {
    await studio.keptOffline();
    deployment.stop();
    await expect(fetch(deployment.address)).rejects.toThrow();
    await studio.page.reload();
    await studio.page.locator('.sample').first().waitFor();
    await studio.chooseSample('Heart');
    await studio.resultOf('heart');
    await studio.drawn('#model-picture');
    expect(await downloads(studio)).toEqual(realFiles);
    // Letters that need fonts which nobody has asked for before.
    const { page } = studio;
    await page.getByLabel('Name of part 1').fill('心ж');
    await page.getByLabel('Name of part 1').press('Enter');
    await page.getByText('Named 心ж.').waitFor();
    expect((await studio.download('PDF')).bytes.length).toBeGreaterThan(1000);
    expect(await page.locator('#message').isVisible()).toBe(false);
    expect(studio.complaints).toEqual([]);
  }));

test('every file of the build is kept, and a reload with options in the address works', () =>
  withDeployment(async (studio, deployment) => {
    await studio.keptOffline();
    deployment.stop();
    await studio.page.goto(`${deployment.address}?workers=1`);
    await studio.page.locator('.sample').first().waitFor();
    const names = await studio.page
      .locator('.sample')
      .evaluateAll((buttons) => buttons.map((button) => (button as HTMLButtonElement).value));
    expect(names.length).toBeGreaterThan(5);
    const materials = names.map((name) => name.replace(/\.obj$/, '.mtl'));
    for (const name of [...names, ...materials]) {
      const size = await studio.page.evaluate(
        async (file) => (await (await fetch(`samples/${file}`)).arrayBuffer()).byteLength,
        name,
      );
      expect(size).toBeGreaterThan(100);
    }
    expect(studio.complaints).toEqual([]);
  }));

test('an open page of a first visit goes on after a new deployment', () =>
  withDeployment(async (studio, deployment) => {
    // Its writer is there before anything is kept.
    await studio.chooseSample('House');
    await studio.resultOf('house');
    await studio.keptOffline();
    await deployment.replace(nextBuild);
    expect(await downloads(studio)).toEqual(realFiles);
    await nextBuildWaits(studio);
    await studio.chooseSample('Heart');
    await studio.resultOf('heart');
    expect(await downloads(studio)).toEqual(realFiles);
    expect(studio.complaints).toEqual([]);
  }));

test('a new deployment takes over when the only page is loaded anew', () =>
  withDeployment(async (studio, deployment) => {
    const { page } = studio;
    await studio.keptOffline();
    const build = await buildOf(page);
    await deployment.replace(nextBuild);
    await nextBuildWaits(studio);
    expect(await cacheCount(studio)).toBe(2);

    // Of two pages neither may lose its files.
    const other = await page.context().newPage();
    await other.goto(deployment.address);
    expect(await buildOf(other)).toBe(build);
    await page.reload();
    expect(await buildOf(page)).toBe(build);
    await other.close();

    // A person who loads it anew meanwhile gets whole pages.
    for (const pause of [0, 30, 100, 250, 500]) {
      await page.waitForTimeout(pause);
      // The page may load itself anew at that moment.
      await page.reload({ waitUntil: 'commit' }).catch(() => undefined);
    }

    // Once is enough, unless the browser counts the closed page for longer than the new one asks.
    await expect
      .poll(() => buildAfterReload(studio), { timeout: 60_000, interval: 100 })
      .toBe(nextBuild);
    await page.locator('.sample').first().waitFor();
    await expect.poll(() => cacheCount(studio), patience).toBe(1);
    deployment.stop();
    await page.reload();
    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    expect(await downloads(studio)).toEqual(realFiles);
    expect(studio.complaints).toEqual([]);
  }));

test('only a page of the build that serves drops the files of others', () =>
  withDeployment(async (studio) => {
    const { page } = studio;
    await studio.keptOffline();
    const before = (): Promise<boolean> =>
      page.evaluate(async (build) => {
        const { scope } = (await navigator.serviceWorker.getRegistration())!;
        return caches.has(`foldwright ${scope} ${build}`);
      }, 'before');
    const complete = (file: string): Promise<void> =>
      page.evaluate(async (name) => {
        const { scope, active } = (await navigator.serviceWorker.getRegistration())!;
        await caches.open(`foldwright ${scope} before`);
        active!.postMessage({ completePage: `${scope}${name}` });
      }, file);
    await complete('assets/app-before.js');
    await page.waitForTimeout(500);
    expect(await before()).toBe(true);
    await page.reload();
    await expect.poll(before, patience).toBe(false);
    expect(studio.complaints).toEqual([]);
  }));

test('a page that cannot be kept says so, and works with its server', () =>
  withDeployment(async (studio, deployment) => {
    await studio.page.getByText('could not be kept on this device').waitFor();
    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    expect(await cacheCount(studio)).toBe(0);
    await deployment.mend();
    await studio.page.reload();
    await studio.keptOffline();
  }, 'icon.svg'));
