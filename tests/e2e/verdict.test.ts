/** The verdict on a result: what stands against building it, where that is, and what mends it. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText } from '../web/model-text.js';
import { cube } from '../web/fixtures.js';
import { useStudio } from './studio-fixture.js';
import { phone, type StudioPage } from './studio-page.js';

const withStudio = useStudio();

const headline = (page: Page) => page.locator('#verdict-title');
const row = (page: Page, code: string) => page.locator(`.finding[data-code="${code}"]`);

/** The cube in one piece at this height, in mm. */
async function open(studio: StudioPage, height: number): Promise<string> {
  await studio.page.fill('#parts', '1');
  await studio.page.selectOption('#sizing', 'height');
  await studio.page.fill('#size', String(height));
  await studio.choose('box.obj', objText(cube));
  return studio.resultOf('box');
}

async function changed(studio: StudioPage, before: string): Promise<string> {
  await studio.page.locator(`#result:not([data-hash="${before}"])`).waitFor();
  return studio.resultOf('box');
}

/** How many pixels of the model's picture have about the colour of an edge that is lit. */
async function litPixels(studio: StudioPage): Promise<number> {
  const isLit = (colour: number): boolean =>
    [16, 8, 0].every(
      (bits) => Math.abs(((colour >> bits) & 255) - ((0xad381e >> bits) & 255)) < 12,
    );
  const colours = await studio.coloursOf('#model-picture');
  return [...colours].reduce((sum, [colour, count]) => sum + (isLit(colour) ? count : 0), 0);
}

test('what is hard to build is shown place by place, and mended by one click', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const small = await open(studio, 8);
    expect(await headline(page).innerText()).toContain('You can build it. Look at 1 thing first');
    const short = row(page, 'short-seams');
    expect(await short.innerText()).toContain('7 edges to glue are too short');
    expect(await page.locator('#remarks').innerText()).not.toContain('hard to glue');
    await studio.drawn('#model-picture');
    expect(await litPixels(studio)).toBe(0);

    const show = short.getByRole('button', { name: 'Show' });
    await show.click();
    const walk = page.locator('#edge-walk-words');
    expect(await walk.innerText()).toBe('7 edges to glue are too short: 1 of 7');
    expect(await page.locator('.edge-light--own').count()).toBeGreaterThan(0);
    await expect.poll(() => litPixels(studio)).toBeGreaterThan(100);
    await show.click();
    expect(await walk.innerText()).toMatch(/: 2 of 7$/);
    await page.getByRole('button', { name: 'Back', exact: true }).click();
    expect(await walk.innerText()).toMatch(/: 1 of 7$/);
    await studio.picture('verdict-shown');
    await page.keyboard.press('Escape');
    await expect.poll(() => litPixels(studio)).toBe(0);

    await short.getByRole('button', { name: 'Make it 20 mm high' }).click();
    const larger = await changed(studio, small);
    expect(await headline(page).innerText()).toContain('Ready to print');
    expect(await page.getByText('20 × 20 × 20 mm').isVisible()).toBe(true);
    // The form says what there is, and nothing is left to be applied.
    expect(await page.inputValue('#size')).toBe('20');
    expect(await page.locator('.pending:not([hidden])').count()).toBe(0);
    await page.getByRole('button', { name: 'Undo: change of size' }).click();
    expect(await changed(studio, larger)).toBe(small);
    expect(await page.inputValue('#size')).toBe('8');
    expect(await page.locator('.pending:not([hidden])').count()).toBe(0);
    expect(studio.complaints).toEqual([]);
  }));

test('nobody is told of success where nothing can be built', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await open(studio, 3);
      const words = 'Do not print it yet: nobody can build it like this';
      expect(await headline(page).innerText()).toContain(words);
      expect(await page.locator('#result-lead').isVisible()).toBe(false);
      expect(await page.locator('#announcement').innerText()).toBe(`Done: ${words}.`);
      await row(page, 'short-seams').getByRole('button', { name: 'Show' }).click();
      // The place and what is told of it are both in the window.
      const light = (await page.locator('.edge-light--own').first().boundingBox())!;
      const card = (await page.locator('#edge-card').boundingBox())!;
      expect(light.y).toBeGreaterThanOrEqual(0);
      expect(light.y).toBeLessThan(phone.height);
      expect(light.y + light.height <= card.y || light.y >= card.y + card.height).toBe(true);
      await studio.picture('verdict-phone');
      expect(studio.complaints).toEqual([]);
    },
    { viewport: phone },
  ));

test('what takes a new search is filled in and left to be applied', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '3');
    await studio.chooseSample('Duck');
    await studio.resultOf('duck');
    const mend = row(page, 'short-seams').getByRole('button', { name: /^Use \d+ triangles$/ });
    const [faces] = (await mend.innerText()).match(/\d+/)!;
    await mend.click();
    expect(await page.inputValue('#faces')).toBe(faces);
    const apply = page.getByRole('button', { name: 'Apply and unfold again' });
    expect(await apply.evaluate((own) => own.matches(':focus'))).toBe(true);
    await page.keyboard.press('Enter');
    await page.locator('#facts div', { hasText: 'Triangles' }).getByText(faces).waitFor();
    expect(studio.complaints).toEqual([]);
  }));
