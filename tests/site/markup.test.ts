/** Every example in HTML does what it says in a browser. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { examplesOf } from './examples.js';
import { withShopPage } from './shop-page.js';

/** What an example shows in the end: the first whose pattern fits its code. */
const ends: readonly (readonly [RegExp, (page: Page) => Promise<unknown>])[] = [
  [/<foldwright-studio[^>]* src=/, (page) => heard(page, 'done')],
  [/<foldwright-studio/, (page) => heard(page, 'foldwright-ready')],
  // Of a model without nets the viewer shows a button at first.
  [
    /src="[^"]*\.obj"/,
    (page) => page.locator('foldwright-viewer').getByRole('button').first().waitFor(),
  ],
  [/<foldwright-viewer/, (page) => heard(page, 'load')],
  [/new Image/, (page) => page.locator('img').waitFor()],
];

/** Waits until the page has heard an event, which `withShopPage` writes down. */
function heard(page: Page, type: string): Promise<unknown> {
  const isHeard = `window.heard.includes(${JSON.stringify(type)})`;
  return page.waitForFunction(isHeard, null, { timeout: 100_000 });
}

test.each(examplesOf('html'))('$name', async ({ code }) => {
  const [, end] = ends.find(([pattern]) => pattern.test(code))!;
  await withShopPage(code, async ({ page, complaints }) => {
    await end(page);
    expect(await page.evaluate('window.heard.includes("error")')).toBe(false);
    expect(complaints).toEqual([]);
  });
});
