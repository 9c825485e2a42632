/** Faces are given to another piece: by a brush on the model, and by the keyboard at an edge. */
import { expect, test } from 'vitest';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

/** The duck in three parts: its bill, its head, and the body below that. */
async function open(studio: StudioPage): Promise<string> {
  await studio.page.fill('#parts', '3');
  await studio.chooseSample('Duck');
  const hash = await studio.resultOf('duck');
  await studio.drawn('#model-picture');
  return hash;
}

async function changed(studio: StudioPage, before: string): Promise<string> {
  await studio.page.locator(`#result:not([data-hash="${before}"])`).waitFor();
  return studio.resultOf('duck');
}

/** Pulls the mouse from the head over the breast, in shares of the picture. */
async function pull(studio: StudioPage, steps: number): Promise<void> {
  const { page } = studio;
  const { x, y, width, height } = (await page.locator('#model-picture').boundingBox())!;
  await page.mouse.move(x + 0.4 * width, y + 0.4 * height);
  await page.mouse.down();
  await page.mouse.move(x + 0.45 * width, y + 0.62 * height, { steps });
}

test('a stroke of the brush is one step of the history', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const first = await open(studio);
    const hint = page.locator('#brush-hint');
    const place = await page.locator('#model-picture').boundingBox();
    expect(await hint.isVisible()).toBe(false);
    await page.getByLabel('paint', { exact: true }).check();
    expect(await hint.isVisible()).toBe(true);
    // Nothing has moved.
    expect(await page.locator('#model-picture').boundingBox()).toEqual(place);
    await pull(studio, 4);
    await studio.picture('brush-stroke');
    await page.mouse.up();
    const painted = await changed(studio, first);
    await page.getByRole('button', { name: 'Undo: faces given to part 2' }).click();
    expect(await changed(studio, painted)).toBe(first);
    // Without the brush the same turns the model.
    await page.getByLabel('paint', { exact: true }).uncheck();
    await pull(studio, 4);
    await page.mouse.up();
    expect(await page.locator('#undo').isVisible()).toBe(false);
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(first);
    expect(studio.complaints).toEqual([]);
  }));

test('a face is given to the piece beside it by the keyboard', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const first = await open(studio);
    const texts = await page.locator('.sheet text').allTextContents();
    const number = texts.find((text) => /^B\d+$/.test(text))!;
    await page.locator('#edge-number').fill(number);
    await page.keyboard.press('Enter');
    const gift = page.getByRole('button', { name: 'Give this face to B' });
    await gift.focus();
    await page.keyboard.press('Enter');
    const given = await changed(studio, first);
    expect(await page.locator('#edge-words').innerText()).not.toContain(`Edge ${number}:`);
    await page.getByRole('button', { name: 'Undo: faces given to part 2' }).click();
    expect(await changed(studio, given)).toBe(first);
    expect(studio.complaints).toEqual([]);
  }));
