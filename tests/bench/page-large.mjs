// Large models in Chromium: seconds from the choice of the file until the check shows the simplified model that it
// proposes, until the next level of triangles is shown, and from the click on "Unfold" to nets on sheets; and the longest task of
// the page's own thread. Takes files as arguments; without any the largest scan there is, and a generated one of a million
// triangles.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { serve } from '../../scripts/serve.mjs';

const load = async (name) => {
  const path = fileURLToPath(new URL(`../../${name}`, import.meta.url));
  return (await runnerImport(path)).module;
};
const { isBuilt, sharedFolder } = await load('tests/web/command.ts');
const { StudioPage } = await load('tests/e2e/studio-page.ts');
const { objText, wavyRing } = await load('tests/web/model-text.ts');

/** Around the ring and its tube; 2 triangles each. */
const million = 707;
const timeout = 120_000;

const watchTasks = () => {
  globalThis.longTasks = [];
  new globalThis.PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) globalThis.longTasks.push(duration);
  }).observe({ type: 'longtask' });
};

/** Seconds until each of some things was seen, and ms of the longest task. */
async function measure({ page }, path) {
  await page.evaluate(watchTasks);
  let before = performance.now();
  const lap = () => {
    const seconds = (performance.now() - before) / 1000;
    before = performance.now();
    return seconds;
  };
  const pictured = (least, most) =>
    page.waitForFunction(
      ([low, high]) => {
        const { shadowRoot } = globalThis.document.querySelector('foldwright-studio');
        const words = shadowRoot.querySelector('#check-look')?.textContent ?? '';
        const triangles = Number(/has ([\d,]+)/.exec(words)?.[1]?.replaceAll(',', ''));
        return triangles >= low && triangles <= high;
      },
      [least, most],
      { timeout },
    );
  await page.locator('#file').setInputFiles(path);
  await pictured(1000, 1500);
  const times = [lap()];
  await page.getByRole('button', { name: '500', exact: true }).click();
  await pictured(400, 500);
  times.push(lap());
  await page.locator('#check').getByRole('button', { name: 'Unfold' }).click();
  await page.locator('#result').waitFor({ timeout });
  times.push(lap());
  return { times, longest: Math.max(0, ...(await page.evaluate(() => globalThis.longTasks))) };
}

const shared = sharedFolder();
if (!isBuilt || shared === null) {
  console.log(
    isBuilt ? 'page large: skipped, the models are missing' : 'page large: skipped, not built',
  );
  process.exit(isBuilt ? 0 : 1);
}
const scratch = mkdtempSync(join(tmpdir(), 'foldwright-large-'));
const models = process.argv.slice(2);
if (models.length === 0) {
  const ring = join(scratch, 'million.obj');
  writeFileSync(ring, objText(wavyRing(million)));
  models.push(join(shared, 'models', 'full', 'nefertiti-lowres.obj'), ring);
}
const server = await serve(fileURLToPath(new URL('../../dist', import.meta.url)));
for (const model of models) {
  const studio = await StudioPage.open(`${server.address}studio/`);
  const { times, longest } = await measure(studio, model);
  const [checked, level, nets] = times.map((seconds) => seconds.toFixed(1));
  console.log(
    `${basename(model)}: check ${checked} s, 500 triangles ${level} s, nets ${nets} s, longest task ${longest.toFixed(0)} ms`,
  );
  await studio.close();
}
server.close();
rmSync(scratch, { recursive: true });
