/** The site's own pages in a browser: demonstrations run to their end, and pages are readable by everybody. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { serve } from '../../scripts/serve.mjs';
import { barriers } from '../e2e/barriers.js';
import { sharedBrowser } from '../e2e/shared-browser.js';
import { paths, site } from './built-pages.js';
import { listen } from './shop-page.js';

let server: Awaited<ReturnType<typeof serve>>;
beforeAll(async () => {
  server = await serve(site);
});
afterAll(() => server.close());

/** Opens a page of the site, of a phone's width by default. */
async function withPage(
  path: string,
  work: (page: Page, complaints: string[]) => Promise<void>,
  colorScheme: 'light' | 'dark' = 'light',
): Promise<void> {
  const viewport = { width: 390, height: 800 };
  const context = await (await sharedBrowser()).newContext({ viewport, colorScheme });
  try {
    const page = await context.newPage();
    const complaints = listen(page);
    await page.goto(server.address + path);
    await work(page, complaints);
    expect(complaints).toEqual([]);
  } finally {
    await context.close();
  }
}

const demos = [
  { path: 'learning.html', action: 'Learn', end: /sorted by part: 6 dark blocks/ },
  { path: 'clustering.html', action: 'Cut into parts', end: /^6 parts/ },
  { path: 'search.html', action: 'Search nets', end: /nets, none with an overlap/ },
];

describe('demonstrations', () => {
  it.each(demos)('of $path run to their end', ({ path, action, end }) =>
    withPage(path, async (page) => {
      const canvas = page.locator('main canvas').first();
      const blank = await canvas.screenshot();
      await page.getByRole('button', { name: action }).click();
      await expect
        .poll(() => page.locator('[role=status]').first().textContent(), { timeout: 100_000 })
        .toMatch(end);
      expect((await canvas.screenshot()).equals(blank)).toBe(false);
    }),
  );
});

/** Pages of the API have one form: a few stand for all. */
const looked = paths.filter((path) => !/^api\/.+\//.test(path) || path.includes('Session'));

describe.each(['light', 'dark'] as const)('in %s colours', (colorScheme) => {
  it.each(looked)('%s can be read on a phone and by everybody', (path) =>
    withPage(
      path,
      async (page) => {
        const overflow = await page.evaluate(
          () => document.documentElement.scrollWidth - innerWidth,
        );
        expect(overflow).toBeLessThanOrEqual(0);
        expect(await barriers(page)).toEqual([]);
      },
      colorScheme,
    ),
  );
});
