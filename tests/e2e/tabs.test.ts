/** A result in a small window: one tab at a time, by keys and by fingers. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { useStudio } from './studio-fixture.js';
import { phone } from './studio-page.js';

const withStudio = useStudio();

// A machine without a screen has none to keep on.
const script = `window.locks = [];
  Object.defineProperty(navigator, 'wakeLock', { value: { request: async () => {
    const lock = { released: false, release: async () => { lock.released = true; } };
    window.locks.push(lock);
    return lock;
  } } });`;

const locks = (page: Page): Promise<boolean[]> =>
  page.evaluate(() =>
    (window as unknown as { locks: { released: boolean }[] }).locks.map((lock) => lock.released),
  );

const tab = (page: Page, name: string) => page.getByRole('tab', { name, exact: true });

/** Waits until just these are to be seen of all parts: a fold that a tab opens is filled a moment later. */
async function expectSeen(page: Page, expected: string[]): Promise<void> {
  const parts = ['#result-model', '#mat-view', '#verdict', '#steps', '#downloads', '#controls'];
  const seen = async () => {
    const shown = await Promise.all(parts.map((selector) => page.locator(selector).isVisible()));
    return parts.filter((_, index) => shown[index]);
  };
  await expect.poll(seen).toEqual(expected);
}

test('the result comes first, and its tabs are walked by keys and tapped by fingers', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      expect(await page.locator('#tabs').isVisible()).toBe(false);
      await studio.chooseSample('House');
      await studio.resultOf('house');
      expect(await page.evaluate(() => scrollY)).toBe(0);
      const model = (await page.locator('#result-model').boundingBox())!;
      expect(model.y + model.height).toBeLessThan(phone.height);
      await expectSeen(page, ['#result-model', '#verdict', '#controls']);

      await tab(page, 'Model').focus();
      await page.keyboard.press('ArrowRight');
      expect(await tab(page, 'Sheets').evaluate((own) => own.matches(':focus'))).toBe(true);
      expect(await tab(page, 'Sheets').getAttribute('aria-selected')).toBe('true');
      expect(await tab(page, 'Model').getAttribute('tabindex')).toBe('-1');
      await expectSeen(page, ['#mat-view']);
      const sheet = (await page.locator('.sheet svg').first().boundingBox())!;
      expect(sheet.width).toBeGreaterThan(300);
      await page.keyboard.press('End');
      await expectSeen(page, ['#downloads']);
      await page.keyboard.press('ArrowRight');
      expect(await tab(page, 'Model').getAttribute('aria-selected')).toBe('true');
      await page.keyboard.press('ArrowLeft');
      expect(await tab(page, 'Save').getAttribute('aria-selected')).toBe('true');
      expect((await studio.download('PDF')).name).toBe('house.pdf');

      expect(await locks(page)).toEqual([]);
      await tab(page, 'Build').tap();
      await expectSeen(page, ['#result-model', '#steps']);
      await page.locator('.step').first().tap();
      const size = await page
        .locator('.step')
        .first()
        .evaluate((step) => Number.parseFloat(getComputedStyle(step).fontSize));
      expect(size).toBeGreaterThanOrEqual(18);
      await studio.picture('tabs-build');
      // The screen stays on for as long as the steps are shown.
      await expect.poll(() => locks(page)).toEqual([false]);
      await tab(page, 'Sheets').tap();
      await expect.poll(() => locks(page)).toEqual([true]);
      await tab(page, 'Build').tap();
      await expect.poll(() => locks(page)).toEqual([true, false]);
      await page.setViewportSize({ width: 1280, height: 800 });
      await expect.poll(() => locks(page)).toEqual([true, true]);
      const overflow = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      expect(overflow).toBe(0);
      expect(studio.complaints).toEqual([]);
    },
    { viewport: phone, hasTouch: true, folded: true, script },
  ));
