/** A run can be watched, and ended at any time, and leaves a page that works. */
import { expect, test } from 'vitest';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

/** A canvas that shows nothing has one colour; edges smoothed by the browser make many. */
const few = 20;

/** Starts a run that takes long enough to be watched. */
async function beginLongRun(studio: StudioPage): Promise<void> {
  await studio.page.fill('#parts', '2');
  await studio.page.selectOption('#solver', 'genetic');
  await studio.chooseSample('Rabbit');
}

/** Presses Cancel as soon as the words of a stage appear. */
async function cancelAt(studio: StudioPage, words: string): Promise<void> {
  await studio.page.evaluate((start) => {
    const stage = document.querySelector('#progress-words')!;
    const observer = new MutationObserver(() => {
      if (!stage.textContent?.startsWith(start)) return;
      observer.disconnect();
      document.querySelector<HTMLElement>('#cancel')!.click();
    });
    observer.observe(stage, { childList: true, characterData: true, subtree: true });
  }, words);
}

test('model, foldability, net and fitness are drawn while a run goes on', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await beginLongRun(studio);
    await page.locator('#net-words', { hasText: 'generation' }).waitFor({ timeout: 60_000 });
    await page.locator('#chart .curve--now').waitFor();
    const words = await page.locator('#net-words').innerText();
    // Generations go on while one looks.
    await page.locator('#net-words', { hasNotText: words }).waitFor();
    for (const canvas of ['#model-canvas', '#matrix', '#chart', '#net']) {
      await expect.poll(() => studio.coloursOf(canvas), { timeout: 20_000 }).toBeGreaterThan(few);
    }
    await page.locator('#cancel').click();
    await page.locator('#announcement', { hasText: 'Cancelled.' }).waitFor();
    expect(await studio.coloursOf('#model-canvas')).toBeGreaterThan(few);
    expect(studio.complaints).toEqual([]);
  }));

test('a run can be ended in every stage, and the next one works', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const stages = ['Reading', 'Learning', 'Choosing the parts', 'Laying', 'Placing'];
    for (const stage of stages) {
      await cancelAt(studio, stage);
      await studio.chooseSample('Duck');
      await page.locator('#announcement', { hasText: 'Cancelled.' }).waitFor({ timeout: 60_000 });
      expect(await page.locator('#progress').isVisible()).toBe(false);
      expect(await page.locator('#message').isVisible()).toBe(false);
      await studio.chooseSample('Cube');
      await studio.resultOf('cube');
      expect(await studio.coloursOf('#model-canvas')).toBeGreaterThan(few);
    }
    expect(studio.complaints).toEqual([]);
  }));

test('the last result comes back when the run after it is cancelled', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    await beginLongRun(studio);
    await page.locator('#workshop').waitFor();
    expect(await page.locator('#result').isVisible()).toBe(false);
    await page.locator('#cancel').click();
    await page.locator('#result').waitFor();
    expect((await studio.download('FOLD')).name).toBe('cube.fold');
    expect(studio.complaints).toEqual([]);
  }));

test('without WebGL the page says so and does all the rest', () =>
  withStudio(
    async (studio) => {
      await studio.chooseSample('Cube');
      await studio.resultOf('cube');
      expect(await studio.page.locator('#model-note').innerText()).toContain('no WebGL 2');
      expect(studio.requests.some((address) => address.includes('model-view'))).toBe(false);
      expect(studio.complaints).toEqual([]);
    },
    {
      script: `const getContext = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, options) {
          return kind === 'webgl2' ? null : getContext.call(this, kind, options);
        };`,
    },
  ));

test('parts can be told apart by hatches', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.chooseSample('Heart');
    await studio.resultOf('heart');
    expect(await page.locator('.sheet .hatch').first().isVisible()).toBe(false);
    await page.locator('#hatch').check();
    expect(await page.locator('.sheet .hatch').first().isVisible()).toBe(true);
    await studio.picture('hatched');
    expect(studio.complaints).toEqual([]);
  }));

test('a model is turned and brought nearer by keys', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.chooseSample('House');
    await studio.resultOf('house');
    const canvas = page.locator('#model-canvas');
    await canvas.focus();
    for (const key of ['ArrowRight', 'ArrowUp', '+']) {
      const before = await canvas.screenshot();
      await page.keyboard.press(key);
      await expect.poll(async () => before.equals(await canvas.screenshot())).toBe(false);
    }
  }));
