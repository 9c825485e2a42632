/** Both elements on a plain page of another origin than their files; `tests/browsers` does the same in other engines. */
import { afterAll, beforeAll, expect, test } from 'vitest';
import { useEmbedded } from '../browsers/embedded-elements.js';
import type { Engine, EnginePage } from '../browsers/engine-page.js';
import { WatchedStudio } from '../browsers/watched-studio.js';
import { serveEmbedding, type EmbeddingSite } from './embedding-site.js';
import { sharedBrowser } from './shared-browser.js';
import { ring, unfoldedRing } from './unfolded-ring.js';

/** Chromium as the other tests here have it: without a window, and so without a screen. */
const headless: Engine = {
  name: 'headless',
  async open(): Promise<EnginePage> {
    const page = await (await sharedBrowser()).newPage();
    return {
      goto: async (address) => void (await page.goto(address)),
      reload: async () => void (await page.reload()),
      evaluate: <Result, Argument>(
        body: (argument: Argument) => Result | Promise<Result>,
        argument?: Argument,
      ) => page.evaluate(body as (given: unknown) => unknown, argument) as Promise<Result>,
      click: (x, y) => page.mouse.click(x, y),
      press: async (...keys) => {
        for (const key of keys) await page.keyboard.press(key);
      },
      resize: (width, height) => page.setViewportSize({ width, height }),
      screenshot: () => page.screenshot(),
      close: () => page.close(),
    };
  },
};

let site: EmbeddingSite;
let hash: string;

beforeAll(async () => {
  const made = await unfoldedRing();
  hash = made.hash;
  site = await serveEmbedding({ 'model.fold': made.fold, 'model.obj': ring });
});

afterAll(() => site.close());

test('a page embeds both elements under the policy of the guide', async () => {
  expect(site.policy).toMatch(
    /^default-src 'none'; script-src http\S+ 'wasm-unsafe-eval'; worker-src http\S+ blob:; connect-src http\S+ 'self'; img-src http\S+ blob: data:$/,
  );
  const studio = await WatchedStudio.open(headless, '', site.address);
  try {
    await useEmbedded(studio, hash);
  } finally {
    await studio.close();
  }
});
