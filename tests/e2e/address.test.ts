/** Models that come by the address of the page, or are pasted into it. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();

const open = (page: Page, search: string) => page.goto(new URL(search, page.url()).href);
const message = (page: Page) => page.locator('#message').innerText();

test('an address asks for a model with options', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(page, '?model=samples/whale.obj&parts=5&height=80&utm_source=mail');
    await studio.resultOf('whale');
    expect(await page.locator('#parts').inputValue()).toBe('5');
    expect(await page.locator('#sizing').inputValue()).toBe('height');
    expect(await page.locator('#size').inputValue()).toBe('80');
    expect(await page.locator('#result-lead').innerText()).toContain('5 parts');
    // The materials that the model names were fetched from beside it.
    expect(await page.locator('#looks').isVisible()).toBe(true);
    expect(studio.complaints).toEqual([]);
  }));

test('an address says what is wrong with it', () =>
  withStudio(async ({ page }) => {
    await open(page, '?height=tall');
    await expect.poll(() => message(page)).toContain("Option 'height': 'tall'");
    await open(page, '?model=https://models.example/cat.obj');
    await expect
      .poll(() => message(page))
      .toContain('“cat.obj” cannot be loaded: it lies on another site');
    await open(page, '?model=samples/nothing.obj');
    await expect.poll(() => message(page)).toContain('“nothing.obj” cannot be loaded.');
  }));

test('a model that is pasted as text or as a file is unfolded; a word is left alone', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const paste = (text: string) =>
      page.evaluate((pasted) => {
        const clipboardData = new DataTransfer();
        clipboardData.setData('text/plain', pasted);
        document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
      }, text);
    await paste('a cat with 4 legs');
    await paste(objText(wavyRing(6)));
    await studio.resultOf('pasted');
    await page.evaluate(
      (content) => {
        const clipboardData = new DataTransfer();
        clipboardData.items.add(new File([content], 'copied.obj'));
        document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
      },
      objText(wavyRing(8)),
    );
    await studio.resultOf('copied');
    expect(studio.complaints).toEqual([]);
  }));
