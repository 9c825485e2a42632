/** A run can be watched, and ended at any time, and leaves a page that works. */
import { expect, test } from 'vitest';
import { cancelAt, stageWords } from './page-clock.js';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

/** Starts a run that takes minutes, so that it can be watched on any machine. */
async function beginLongRun(studio: StudioPage): Promise<void> {
  await studio.page.fill('#parts', '2');
  await studio.page.selectOption('#solver', 'genetic');
  await studio.choose('ring.obj', objText(wavyRing(24)));
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
    for (const canvas of ['#model-picture', '#matrix', '#chart', '#net'])
      await studio.drawn(canvas);
    await page.locator('#cancel').click();
    await page.locator('#announcement', { hasText: 'Cancelled.' }).waitFor();
    await studio.drawn('#model-picture');
    expect(studio.complaints).toEqual([]);
  }));

test('a run can be ended in every stage, and the next one works', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    for (const stage of stageWords) {
      const answered = cancelAt(studio, stage);
      await studio.chooseSample('Duck');
      await answered;
      expect(await page.locator('#announcement').textContent()).toBe('Cancelled.');
      expect(await page.locator('#progress').isVisible()).toBe(false);
      expect(await page.locator('#message').isVisible()).toBe(false);
      await studio.chooseSample('Cube');
      await studio.resultOf('cube');
      await studio.drawn('#model-picture');
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
