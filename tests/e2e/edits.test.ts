/** Parts of a result are chosen, split and merged, and all of that can be taken back. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { pointInside } from './sheet-points.js';
import { useStudio } from './studio-fixture.js';
import { phone, type StudioPage } from './studio-page.js';

const withStudio = useStudio();

const part = (page: Page, number: number) =>
  page.getByRole('button', { name: new RegExp(`^Part ${number}, piece`) });
const press = (page: Page, name: string) => page.getByRole('button', { name }).click();

async function open(studio: StudioPage, parts: number): Promise<void> {
  await studio.page.fill('#parts', String(parts));
  await studio.choose('ring.obj', objText(wavyRing(12)));
  await studio.resultOf('ring');
}

/** The numbers of the parts that are chosen. */
async function chosen(page: Page): Promise<number[]> {
  const names = await page
    .locator('.part[aria-pressed="true"] span:not(.part__swatch)')
    .allInnerTexts();
  return names.map((name) => Number.parseInt(name.replace('Part ', ''), 10));
}

/** Clicks a piece on a sheet; with Shift its part is chosen beside others, or no longer. */
async function clickPiece(page: Page, selector: string, key?: 'Shift'): Promise<void> {
  const [x, y] = await pointInside(page, selector);
  if (key) await page.keyboard.down(key);
  await page.mouse.click(x, y);
  if (key) await page.keyboard.up(key);
}

/** The hash of the result that a change leads to. */
async function changed(studio: StudioPage, before: string): Promise<string> {
  await studio.page.locator(`#result:not([data-hash="${before}"])`).waitFor();
  return studio.resultOf('ring');
}

test('a part is split, two are merged, and both are taken back', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio, 4);
    const lead = page.locator('#result-lead');
    const first = (await page.locator('#result').getAttribute('data-hash')) ?? '';
    expect(await page.locator('#undo').isHidden()).toBe(true);

    await part(page, 2).click();
    expect(await page.locator('[data-area][data-selected]').count()).toBe(1);
    await press(page, 'Split this part');
    const split = await changed(studio, first);
    expect(await lead.innerText()).toMatch(/^5 parts/);
    expect(await chosen(page)).toEqual([2, 5]);
    await studio.drawn('#model-picture');
    await studio.picture('edits-split');

    await press(page, 'Merge these two');
    const merged = await changed(studio, split);
    expect(await lead.innerText()).toMatch(/^4 parts/);
    expect(await chosen(page)).toEqual([2]);

    await press(page, 'Undo: merging of parts 2 and 5');
    expect(await changed(studio, merged)).toBe(split);
    await press(page, 'Undo: split of part 2');
    expect(await changed(studio, split)).toBe(first);
    expect(await page.locator('#undo').isHidden()).toBe(true);
    expect(studio.complaints).toEqual([]);
  }));

test('what was taken back is made again, by button and by keys', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio, 4);
    const first = (await page.locator('#result').getAttribute('data-hash')) ?? '';
    const redo = page.locator('#redo');
    expect(await redo.isHidden()).toBe(true);
    await part(page, 2).click();
    await press(page, 'Split this part');
    const split = await changed(studio, first);

    await press(page, 'Undo: split of part 2');
    expect(await changed(studio, split)).toBe(first);
    await studio.picture('edits-redo');
    await press(page, 'Redo: split of part 2');
    expect(await changed(studio, first)).toBe(split);
    expect(await redo.isHidden()).toBe(true);

    await page.keyboard.press('Control+z');
    expect(await changed(studio, split)).toBe(first);
    // In a field the keys are the field's own.
    await page.locator('#parts').press('Control+Shift+Z');
    await page.waitForTimeout(500);
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(first);
    await page.locator('#split').press('Control+Shift+Z');
    expect(await changed(studio, first)).toBe(split);
    await page.keyboard.press('Control+z');
    expect(await changed(studio, split)).toBe(first);

    // Another change takes the place of what was taken back.
    await part(page, 1).click();
    await press(page, 'Split this part');
    await changed(studio, first);
    expect(await redo.isHidden()).toBe(true);
    expect(await page.locator('#undo').innerText()).toBe('Undo: split of part 1');
    expect(studio.complaints).toEqual([]);
  }));

test('a click on the model or on a sheet chooses a part', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio, 2);
    await studio.drawn('#model-picture');
    const box = (await page.locator('#model-picture').boundingBox())!;
    // The ring is seen from the front, and as high as the picture allows: its tube is left of the middle.
    const left = box.x + 0.5 * box.width - 0.27 * Math.min(box.width, box.height);
    await page.mouse.click(left, box.y + 0.5 * box.height);
    await expect.poll(() => chosen(page).then(({ length }) => length)).toBe(1);
    const [picked] = await chosen(page);
    await page.mouse.click(box.x + 2, box.y + 2);
    expect(await page.locator('#piece-words').innerText()).toMatch(/^Piece [AB]: /);
    await clickPiece(page, '[data-area]:not([data-selected])', 'Shift');
    expect(await chosen(page)).toEqual([1, 2]);
    await clickPiece(page, '[data-area]', 'Shift');
    expect(await chosen(page)).toHaveLength(1);
    expect([1, 2]).toContain(picked);
    // Without a key the other one is no longer chosen.
    await clickPiece(page, '[data-area]:not([data-selected])');
    expect(await chosen(page)).toHaveLength(1);
    // A drag turns the model and chooses nothing.
    const before = await chosen(page);
    await page.locator('#model-picture').scrollIntoViewIfNeeded();
    // Clicks on the sheets may have scrolled the page.
    const now = (await page.locator('#model-picture').boundingBox())!;
    await page.mouse.move(now.x + 0.25 * now.width, now.y + 0.5 * now.height);
    await page.mouse.down();
    await page.mouse.move(now.x + 0.6 * now.width, now.y + 0.5 * now.height, { steps: 4 });
    await page.mouse.up();
    await page.waitForTimeout(300);
    expect(await chosen(page)).toEqual(before);
    expect(studio.complaints).toEqual([]);
  }));

test('the keyboard alone is enough, and what cannot be done is said', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await open(studio, 3);
      const first = (await page.locator('#result').getAttribute('data-hash')) ?? '';
      await page.locator('#split').focus();
      await page.keyboard.press('Enter');
      expect(await page.locator('#progress').isHidden()).toBe(true);
      await part(page, 1).focus();
      await page.keyboard.press('Space');
      await page.fill('#split-into', '50');
      await page.locator('#split').focus();
      await page.keyboard.press('Enter');
      const second = await changed(studio, first);
      expect(await page.locator('#result-lead').innerText()).toMatch(/^52 parts/);
      await studio.picture('edits-phone');
      await page.locator('#undo').focus();
      await page.keyboard.press('Enter');
      expect(await changed(studio, second)).toBe(first);
      expect(await page.locator('#split').evaluate((own) => own.matches(':focus'))).toBe(true);
      expect(studio.complaints).toEqual([]);
    },
    { viewport: phone },
  ));

test('a change that is cancelled, or cannot be made, leaves the result as it was', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '2');
    // Long enough to be cancelled.
    await page.locator('#runs').evaluate((field: HTMLInputElement) => (field.value = '30000'));
    await studio.choose('ring.obj', objText(wavyRing(6)));
    await page.locator('#result-title', { hasText: 'ring' }).waitFor({ timeout: 120_000 });
    const first = await studio.resultOf('ring');
    await part(page, 1).click();
    await press(page, 'Split this part');
    // At once: a click of the mouse waits until the button stands still, and the change goes on meanwhile.
    await page.locator('#status #cancel').waitFor();
    await page.locator('#status #cancel').dispatchEvent('click');
    await page.locator('#progress').waitFor({ state: 'hidden' });
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(first);
    expect(await chosen(page)).toEqual([1]);
    await expect
      .poll(() => page.locator('#announcement').innerText())
      .toBe('Cancelled. All is as it was.');

    await page.locator('#split-into').evaluate((field: HTMLInputElement) => (field.max = '100'));
    await page.fill('#split-into', '100');
    await press(page, 'Split this part');
    expect(await studio.message()).toMatch(/^Nothing was changed\s+Part 1 cannot become 100 parts/);
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(first);
    expect(studio.complaints).toEqual([]);
  }));
