/** After one visit everything works without a server, and an open page survives a new deployment. */
import { expect, test } from 'vitest';
import { Deployment } from './deployment.js';
import { StudioPage } from './studio-page.js';

const formats = [
  'PDF',
  'SVG',
  'Pictures (PNG)',
  'Machine (DXF)',
  'FOLD',
  'Folding animation (GLB)',
];
const nextTitle = 'The next build';

async function withDeployment(
  work: (studio: StudioPage, deployment: Deployment) => Promise<void>,
  missing?: string,
): Promise<void> {
  const deployment = await Deployment.start();
  try {
    if (missing) await deployment.lose(missing);
    const studio = await StudioPage.open(deployment.address);
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
async function titleAfterReload({ page }: StudioPage): Promise<string> {
  await page.reload();
  const isNext = (title: string): boolean => document.title === title;
  await page.waitForFunction(isNext, nextTitle, { timeout: 10_000 }).catch(() => undefined);
  return page.title();
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
    for (const name of names) {
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
    await deployment.replace(nextTitle);
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
    const title = await page.title();
    await deployment.replace(nextTitle);
    await nextBuildWaits(studio);
    expect(await cacheCount(studio)).toBe(2);

    // Of two pages neither may lose its files.
    const other = await page.context().newPage();
    await other.goto(deployment.address);
    expect(await other.title()).toBe(title);
    await page.reload();
    expect(await page.title()).toBe(title);
    await other.close();

    // Once is enough, unless the browser counts the closed page for longer than the new one asks.
    await expect
      .poll(() => titleAfterReload(studio), { timeout: 60_000, interval: 100 })
      .toBe(nextTitle);
    await page.locator('.sample').first().waitFor();
    await expect.poll(() => cacheCount(studio), patience).toBe(1);
    deployment.stop();
    await page.reload();
    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    expect(await downloads(studio)).toEqual(realFiles);
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
