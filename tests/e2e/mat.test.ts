/** Sheets on the mat: their size, the part of them that is seen, and the tools on them at any of both. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { pointInside } from './sheet-points.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

type Point = [x: number, y: number];

async function open(studio: StudioPage): Promise<void> {
  await studio.page.fill('#parts', '3');
  await studio.choose('ring.obj', objText(wavyRing(12)));
  await studio.resultOf('ring');
}

/** An edge that is glued to one of another piece: its number, and its middle on its sheet, in mm from above. */
async function someEdge(page: Page): Promise<{ number: string; sheet: number; at: Point }> {
  const texts = await page.locator('.sheet text').allTextContents();
  await page.fill(
    '#edge-number',
    texts.find((text) => /^[A-C][0-9]+$/.test(text))!,
  );
  await page.locator('#edge-number').press('Enter');
  const number = /^Edge (\S+):/.exec(await page.locator('#edge-words').innerText())![1]!;
  const place = await page.locator('.sheet').evaluateAll((sheets) => {
    const sheet = sheets.findIndex((one) => one.querySelector('.edge-light--own'));
    const path = sheets[sheet]!.querySelector<SVGPathElement>('.edge-light--own')!;
    const [x1, y1, x2, y2] = path
      .getAttribute('d')!
      .match(/-?[\d.]+/g)!
      .map(Number);
    return { sheet, at: [(x1! + x2!) / 2, (y1! + y2!) / 2] as [number, number] };
  });
  await page.keyboard.press('Escape');
  return { number, ...place };
}

/** Where a place of a sheet is in the window. */
function inWindow(page: Page, { sheet, at }: { sheet: number; at: Point }): Promise<Point> {
  return page
    .locator('.sheet svg')
    .nth(sheet)
    .evaluate((svg: SVGSVGElement, [x, y]) => {
      const point = new DOMPoint(x, y).matrixTransform(svg.getScreenCTM()!);
      return [point.x, point.y] as [number, number];
    }, at);
}

const near = (one: Point, other: Point): number => Math.hypot(one[0] - other[0], one[1] - other[1]);

/** What the line above the sheets says with the mouse at a place. */
async function said(page: Page, [x, y]: Point): Promise<string> {
  await page.mouse.move(x + 3, y + 3);
  await page.mouse.move(x, y);
  return page.locator('#edge-line').innerText();
}

const widthOf = (page: Page): Promise<number> =>
  page
    .locator('.sheet svg')
    .first()
    .evaluate((svg) => svg.getBoundingClientRect().width);

test('the wheel zooms about the pointer, the space bar pans, and the tools still find the edge', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    const edge = await someEdge(page);
    const begin = await inWindow(page, edge);
    const words = await said(page, begin);
    expect(words).toContain(`Edge ${edge.number}: glued to`);
    const small = await widthOf(page);

    // First to a size at which the mat can be scrolled both ways, then about the edge.
    for (let i = 0; i < 4; ++i) await page.mouse.wheel(0, -100);
    await expect.poll(() => widthOf(page)).toBeCloseTo(small * 1.15 ** 4, 0);
    const at = await inWindow(page, edge);
    await page.mouse.move(...at);
    await page.mouse.wheel(0, -200);
    await expect.poll(() => widthOf(page)).toBeCloseTo(small * 1.15 ** 6, 0);
    const zoomed = await inWindow(page, edge);
    expect(near(zoomed, at)).toBeLessThan(2);
    expect(await said(page, zoomed)).toBe(words);

    // In a field the space bar is the field's own.
    await page.locator('#sheets').focus();
    await page.keyboard.down('Space');
    await page.mouse.down();
    await page.mouse.move(zoomed[0] - 50, zoomed[1] - 30, { steps: 4 });
    await page.mouse.up();
    await page.keyboard.up('Space');
    const panned = await inWindow(page, edge);
    expect(near(panned, [zoomed[0] - 50, zoomed[1] - 30])).toBeLessThan(2);
    // Nothing was chosen by it, or taken along.
    expect(await page.locator('#edge-card').isHidden()).toBe(true);
    expect(await page.locator('#piece-card').isHidden()).toBe(true);
    expect(await said(page, panned)).toBe(words);

    // The middle button takes it back.
    await page.mouse.down({ button: 'middle' });
    await page.mouse.move(panned[0] + 50, panned[1] + 30, { steps: 4 });
    await page.mouse.up({ button: 'middle' });
    const back = await inWindow(page, edge);
    expect(near(back, zoomed)).toBeLessThan(2);
    await page.mouse.click(...back);
    expect(await page.locator('#edge-words').innerText()).toContain(`Edge ${edge.number}:`);
    await page.keyboard.press('Escape');
    await page.mouse.click(...(await pointInside(page, '[data-area="B"]')));
    expect(await page.locator('#piece-words').innerText()).toMatch(/^Piece B: /);
    await studio.picture('mat-zoomed');
    expect(studio.complaints).toEqual([]);
  }));

test('a whole sheet, all of them, or any size by keys; the rulers measure what is printed', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.selectOption('#sizing', 'height');
    await page.fill('#size', '300');
    await open(studio);
    expect(await page.locator('.sheet').count()).toBeGreaterThan(1);
    const view = (await page.locator('#mat-view').boundingBox())!;
    const isSeen = async (index: number): Promise<boolean> => {
      const { x, y, width, height } = (await page.locator('.sheet svg').nth(index).boundingBox())!;
      return (
        x >= view.x &&
        y >= view.y &&
        x + width <= view.x + view.width + 1 &&
        y + height <= view.y + view.height + 1
      );
    };
    expect(await isSeen(0)).toBe(true);
    await page.locator('#sheets').focus();
    const width = await widthOf(page);
    await page.keyboard.press('+');
    expect(await widthOf(page)).toBeCloseTo(1.25 * width, 0);
    await page.keyboard.press('-');
    expect(await widthOf(page)).toBeCloseTo(width, 0);
    await page.locator('#zoom').fill('800');
    expect(await widthOf(page)).toBeCloseTo(800, 0);
    expect(await isSeen(0)).toBe(false);
    await page.getByRole('button', { name: 'All', exact: true }).click();
    for (let i = 0; i < (await page.locator('.sheet').count()); ++i) {
      expect(await isSeen(i)).toBe(true);
    }
    await page.getByRole('button', { name: 'Fit', exact: true }).click();
    expect(await widthOf(page)).toBeCloseTo(width, 0);

    // From 0 at the left edge of the sheet in the middle, in the scale of the sheets.
    await page.waitForTimeout(200);
    const ruler = await page.locator('#ruler-across').evaluate((svg) => {
      const { left } = svg.getBoundingClientRect();
      return [...svg.querySelectorAll('text')].map((text) => {
        const x = Number(/translate\(([-\d.]+)/.exec(text.getAttribute('transform')!)![1]);
        return [Number(text.textContent), left + x - 3] as const;
      });
    });
    const lefts = await page
      .locator('.sheet svg')
      .evaluateAll((sheets) => sheets.map((svg) => svg.getBoundingClientRect().left));
    const zero = ruler.find(([mm]) => mm === 0)![1];
    expect(Math.min(...lefts.map((left) => Math.abs(left - zero)))).toBeLessThan(1);
    const hundred = ruler.find(([mm]) => mm === 100)![1];
    expect((hundred - zero) / 100).toBeCloseTo(width / 210, 1);
    expect(studio.complaints).toEqual([]);
  }));
