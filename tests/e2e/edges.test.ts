/** Edges on the sheets are pointed at, chosen and changed. */
import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import { phone, type StudioPage } from './studio-page.js';

const withStudio = useStudio();

const press = (page: Page, name: string) => page.getByRole('button', { name, exact: true }).click();
const card = (page: Page) => page.locator('#edge-card');
const words = (page: Page) => page.locator('#edge-words');

async function open(studio: StudioPage): Promise<string> {
  await studio.page.fill('#parts', '3');
  await studio.choose('ring.obj', objText(wavyRing(12)));
  return studio.resultOf('ring');
}

/** The hash of the result that a change leads to. */
async function changed(studio: StudioPage, before: string): Promise<string> {
  await studio.page.locator(`#result:not([data-hash="${before}"])`).waitFor();
  return studio.resultOf('ring');
}

type Point = readonly [x: number, y: number];

/** The middles of the first lines of paths, in the window. */
function middlesOf(lines: Locator): Promise<Point[]> {
  return lines.evaluateAll((paths) =>
    (paths as SVGPathElement[]).map((path) => {
      const [x1, y1, x2, y2] = path
        .getAttribute('d')!
        .match(/-?[\d.]+/g)!
        .map(Number);
      const middle = new DOMPoint((x1! + x2!) / 2, (y1! + y2!) / 2);
      const { x, y } = middle.matrixTransform(path.getScreenCTM()!);
      return [x, y] as const;
    }),
  );
}

/** The same of one path, which is brought into view. */
async function middleOf(line: Locator): Promise<Point> {
  await line.scrollIntoViewIfNeeded();
  const [middle] = await middlesOf(line);
  return middle!;
}

function nearestOf([x, y]: Point, points: readonly Point[]): Point {
  const away = (point: Point): number => Math.hypot(point[0] - x, point[1] - y);
  return points.reduce((best, point) => (away(point) < away(best) ? point : best));
}

/** Writes a number into the field and finds its edge by the keyboard. */
async function find(page: Page, number: string): Promise<void> {
  await page.locator('#edge-number').focus();
  await page.keyboard.press('Control+a');
  await page.keyboard.type(number);
  await page.keyboard.press('Enter');
}

/** A number that is printed on a piece at what is glued to another piece, such as B1. */
async function printedNumber(page: Page): Promise<string> {
  const texts = await page.locator('.sheet text').allTextContents();
  return texts.find((text) => /^[A-C][0-9]+$/.test(text))!;
}

test('an edge under the pointer lights what it is glued to, and is cut and glued by clicks', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    await find(page, await printedNumber(page));
    const [x, y] = await middleOf(page.locator('.edge-light--own').first());
    await page.keyboard.press('Escape');
    expect(await card(page).isHidden()).toBe(true);
    expect(await page.locator('.edge-light').count()).toBe(0);

    const place = await page.locator('#sheets').boundingBox();
    await page.mouse.move(x, y);
    await page.locator('.edge-light--partner').first().waitFor({ state: 'attached' });
    expect(await page.locator('#edge-line').innerText()).toMatch(
      /^Edge [A-C]\d+: glued to [A-C]\d+/,
    );
    await page.mouse.click(x, y);
    expect(await words(page).innerText()).toMatch(/^Edge [A-C]\d+: glued to .*flap/);
    // Nothing has moved.
    expect(await page.locator('#sheets').boundingBox()).toEqual(place);
    await studio.picture('edges-chosen');

    await press(page, 'Make it a fold');
    await expect
      .poll(() => page.locator('#edge-outcome').innerText())
      .toMatch(/^Glued together|^The two pieces would overlap/);
    await page.keyboard.press('Escape');
    const second = (await page.locator('#result').getAttribute('data-hash')) ?? '';

    const fold = page
      .locator('[data-layer="fold-mountain"] line, [data-layer="fold-mountain"] path')
      .first();
    await page.mouse.click(...(await middleOf(fold)));
    expect(await words(page).innerText()).toMatch(/^Mountain fold of piece [A-C], \d+°\.$/);
    await press(page, 'Cut here');
    const cut = await changed(studio, second);
    await expect.poll(() => page.locator('#edge-outcome').innerText()).toMatch(/^Cut\. There are/);
    await studio.picture('edges-cut');
    await page.getByRole('button', { name: /^Undo: cut in/ }).click();
    expect(await changed(studio, cut)).toBe(second);
    expect(await words(page).innerText()).toMatch(/^Mountain fold/);
    expect(studio.complaints).toEqual([]);
  }));

test('a seam is found by its number and its flap turned by the keyboard alone', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      const first = await open(studio);
      await studio.showTab('Sheets');
      await find(page, '999');
      expect(await words(page).innerText()).toBe('No edge and no piece is called 999.');
      const number = await printedNumber(page);
      await find(page, number);
      const before = await words(page).innerText();
      expect(before).toMatch(new RegExp(`^Edge ${number}: glued to`));
      await studio.picture('edges-phone');
      // Past the buttons of the field and of the way to paper, the tabs, and the first button of the card.
      for (let i = 0; i < 5; ++i) await page.keyboard.press('Tab');
      const turn = page.getByRole('button', { name: 'Flap on the other side' });
      expect(await turn.evaluate((own) => own.matches(':focus'))).toBe(true);
      await page.keyboard.press('Enter');
      const turned = await changed(studio, first);
      expect(await words(page).innerText()).not.toBe(before);
      expect(await card(page).evaluate((own) => own.matches(':focus-within'))).toBe(true);
      await page.getByRole('button', { name: `Undo: flap of ${number} turned` }).click();
      expect(await changed(studio, turned)).toBe(first);
      expect(await words(page).innerText()).toBe(before);
      expect(studio.complaints).toEqual([]);
    },
    { viewport: phone },
  ));

test('an edge is locked, found again by its sign, and let go', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    const number = await printedNumber(page);
    await find(page, number);
    await press(page, 'Always cut here');
    // Both sides of the cut have a sign.
    await expect.poll(() => page.locator('.lock-sign--cut').count()).toBe(2);
    await expect.poll(() => words(page).innerText()).toContain('Locked: it is always cut.');
    const join = page.getByRole('button', { name: 'Make it a fold' });
    expect(await join.isVisible()).toBe(false);
    expect(await page.locator('#undo').innerText()).toBe(`Undo: always cut at ${number}`);
    await studio.picture('edges-locked');
    await press(page, 'Let the program choose');
    await expect.poll(() => page.locator('.lock-sign').count()).toBe(0);
    expect(await join.isVisible()).toBe(true);
    await page.getByRole('button', { name: `Undo: lock taken away at ${number}` }).click();
    await expect.poll(() => page.locator('.lock-sign--cut').count()).toBe(2);
    expect(studio.complaints).toEqual([]);
  }));

test('a flap gets another height by its field, and by its top in a hand', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const first = await open(studio);
    const number = await printedNumber(page);
    await find(page, number);
    const field = page.locator('#edge-height');
    const usual = Number(await field.inputValue());
    expect(usual).toBeGreaterThan(2);
    await field.fill('2.5');
    await field.press('Enter');
    const lower = await changed(studio, first);
    expect(Number(await field.inputValue())).toBe(2.5);
    await page.getByRole('button', { name: `Undo: flap of ${number} 2.5 mm high` }).click();
    expect(await changed(studio, lower)).toBe(first);
    expect(Number(await field.inputValue())).toBe(usual);

    await field.fill('900');
    await field.press('Enter');
    expect(Number(await field.inputValue())).toBe(usual);
    await field.fill('2');
    await field.press('Escape');
    expect(Number(await field.inputValue())).toBe(usual);
    expect(await card(page).isVisible()).toBe(true);

    const grip = page.locator('.edge-light--grip');
    const top = await middleOf(grip);
    const base = nearestOf(
      top,
      await middlesOf(page.locator('.edge-light--own, .edge-light--partner')),
    );
    await page.mouse.move(...top);
    await page.mouse.down();
    await page.mouse.move(...base, { steps: 4 });
    await page.locator('#flap-ghost path').waitFor({ state: 'attached' });
    const pulled = Number(await field.inputValue());
    expect(pulled).toBeLessThan(usual);
    await studio.picture('edges-flap-pulled');
    await page.keyboard.press('Escape');
    expect(Number(await field.inputValue())).toBe(usual);
    await page.mouse.up();
    expect(await studio.resultOf('ring')).toBe(first);

    await page.mouse.move(...top);
    await page.mouse.down();
    await page.mouse.move(...base, { steps: 4 });
    await page.mouse.up();
    await changed(studio, first);
    expect(Number(await field.inputValue())).toBe(pulled);
    expect(studio.complaints).toEqual([]);
  }));
