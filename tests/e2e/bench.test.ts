/** The bench: a page that stands still, with areas that scroll by themselves, and a border between two of them. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { shiftsOf, watchShifts } from './layout-shifts.js';
import { useStudio } from './studio-fixture.js';
import { phone } from './studio-page.js';

const withStudio = useStudio();

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

const boxOf = async (page: Page, selector: string) => (await page.locator(selector).boundingBox())!;

/** Whether the window shows all of the page. */
const standsStill = (page: Page): Promise<boolean> =>
  page.evaluate(() => {
    scrollTo(0, 1000);
    const { scrollWidth, scrollHeight } = document.documentElement;
    return scrollY === 0 && scrollHeight <= innerHeight && scrollWidth <= innerWidth;
  });

/** Whether something of one box lies within another. */
function meet(a: Box, b: Box): boolean {
  const isBeside = a.x + a.width <= b.x || b.x + b.width <= a.x;
  return !isBeside && a.y < b.y + b.height && b.y < a.y + a.height;
}

test.each([
  { name: 'desktop', viewport: { width: 1366, height: 768 } },
  { name: 'phone', viewport: phone },
])('a long fault on a $name keeps to the strip, and all of it can be read', ({ name, viewport }) =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await studio.chooseSample('House');
      await studio.resultOf('house');
      const model = await boxOf(page, '#result-model');
      await studio.choose(`${'a long name of a letter '.repeat(9)}.docx`, 'Dear Sir or Madam');
      const words = await studio.message();
      const [strip, message] = [await boxOf(page, '#status'), await boxOf(page, '#message')];
      expect(message.height).toBeLessThan(strip.height);
      expect(meet(message, model)).toBe(false);
      expect(await boxOf(page, '#result-model')).toEqual(model);
      await studio.picture(`fault-${name}`);

      const more = page.locator('#message-more');
      expect(await more.getAttribute('aria-expanded')).toBe('false');
      await more.focus();
      await page.keyboard.press('Enter');
      const isWhole = (): Promise<boolean> =>
        page
          .locator('#message-words')
          .evaluate(({ scrollHeight, clientHeight }) => scrollHeight <= clientHeight);
      expect(await isWhole()).toBe(true);
      expect(await studio.message()).toContain(words.slice(-40).trim());
      expect(await boxOf(page, '#result-model')).toEqual(model);
      await studio.picture(`fault-${name}-read`);
      await page.keyboard.press('Enter');
      expect(await boxOf(page, '#message')).toEqual(message);
      expect(await isWhole()).toBe(false);
      // What fits has no button for more.
      await page.locator('#message-close').click();
      await studio.choose('empty.stl', '');
      await studio.message();
      if (name === 'desktop') expect(await more.isVisible()).toBe(false);
      expect(studio.complaints).toEqual([]);
    },
    { viewport, folded: true },
  ),
);

const sizes = [
  { width: 900, height: 700 },
  { width: 1366, height: 768 },
  { width: 1440, height: 900 },
  { width: 2560, height: 1440 },
];

/** Model, sheets and what is told of them are beside each other, from the strip to the foot. */
async function expectBeside(page: Page, { width, height }: (typeof sizes)[number]): Promise<void> {
  const [model, sheets, inspector] = await Promise.all(
    ['#result-model', '#mat-view', '#inspector'].map((selector) => boxOf(page, selector)),
  );
  expect(model!.x + model!.width).toBeLessThanOrEqual(sheets!.x);
  expect(sheets!.x + sheets!.width).toBeLessThanOrEqual(inspector!.x + 1);
  expect(inspector!.x + inspector!.width).toBeLessThanOrEqual(width + 1);
  for (const box of [model!, sheets!, inspector!]) {
    expect(box.y).toBeLessThan(200);
    expect(box.y + box.height).toBeLessThanOrEqual(height);
    expect(box.y + box.height).toBeGreaterThan(height - 40);
  }
}

test('a page with a result does not scroll, nor move, at any size', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      for (const [index, viewport] of sizes.entries()) {
        const { width } = viewport;
        await page.setViewportSize(viewport);
        await shiftsOf(page);
        await watchShifts(page);
        // Another model each time, so that the next result can be told from the one before.
        const sample = index % 2 === 0 ? 'House' : 'Cube';
        await studio.chooseSample(sample);
        await studio.resultOf(sample.toLowerCase());
        await studio.drawn('#model-picture');
        expect([width, await shiftsOf(page)]).toEqual([width, []]);
        expect([width, await standsStill(page)]).toEqual([width, true]);
        await expectBeside(page, viewport);
        await studio.picture(`bench-${width}`);
      }
      expect(studio.complaints).toEqual([]);
    },
    { viewport: sizes[0]!, folded: true },
  ));

test.each([
  { name: 'desktop', viewport: { width: 1366, height: 768 } },
  { name: 'phone', viewport: phone },
])('nothing moves while a longer run goes, when it comes, and when one fails: $name', (options) =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await watchShifts(page);
      await studio.chooseSample('Cat');
      await studio.resultOf('cat');
      await studio.drawn('#model-picture');
      expect(await shiftsOf(page)).toEqual([]);
      // A second run takes the place of the first result, and one that fails leaves it.
      await studio.choose('ring.obj', objText(wavyRing(12)));
      await studio.resultOf('ring');
      await studio.choose('broken.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n');
      await studio.message();
      expect(await shiftsOf(page)).toEqual([]);
      expect(studio.complaints).toEqual([]);
    },
    { viewport: options.viewport, folded: true },
  ),
);

test('the start shows no options, and what it takes to build each sample', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      expect(
        await page.locator('#controls :is(input:not([type=file]), select):visible').count(),
      ).toBe(0);
      const efforts = await page.locator('.sample__effort').allInnerTexts();
      expect(efforts).toHaveLength(12);
      for (const words of efforts) {
        expect(words).toMatch(/^(Easy|Medium|Hard): \d+ pieces?\s+about .* (minutes|hours?)$/);
      }
      await page.getByText('Paper, size and parts').click();
      expect(await page.locator('#parts').isVisible()).toBe(true);
      expect(await page.locator('#seed').isVisible()).toBe(false);
      await page.getByText('More options').click();
      expect(await page.locator('#seed').isVisible()).toBe(true);
    },
    { folded: true },
  ));

test('the border between model and sheets is moved by keys and by hand, and remembered', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      const splitter = page.locator('#splitter');
      const share = () => splitter.getAttribute('aria-valuenow').then(Number);
      await studio.chooseSample('Cube');
      await studio.resultOf('cube');
      const { width } = await boxOf(page, '#result-model');
      expect(await splitter.getAttribute('role')).toBe('separator');
      expect(await share()).toBe(40);
      await splitter.focus();
      await page.keyboard.press('ArrowRight');
      await page.keyboard.press('Shift+ArrowRight');
      expect(await share()).toBe(52);
      const wide = await boxOf(page, '#result-model');
      expect(wide.width / width).toBeCloseTo(52 / 40, 1);
      await page.keyboard.press('Home');
      expect(await share()).toBe(20);

      const bar = await boxOf(page, '#splitter');
      const room = await boxOf(page, '#result');
      await page.mouse.move(bar.x + bar.width / 2, bar.y + 100);
      await page.mouse.down();
      await page.mouse.move(room.x + 0.6 * room.width, bar.y + 120, { steps: 4 });
      await page.mouse.up();
      expect(await share()).toBe(60);
      expect(await standsStill(page)).toBe(true);

      await page.reload();
      await studio.chooseSample('Cube');
      await studio.resultOf('cube');
      expect(await share()).toBe(60);
      await splitter.dblclick();
      expect(await share()).toBe(40);
      expect(studio.complaints).toEqual([]);
    },
    { folded: true },
  ));

test('settings and what is chosen stand beside the sheets, and push nothing away', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await studio.chooseSample('House');
      await studio.resultOf('house');
      const places = () =>
        Promise.all(
          ['#result-model', '#sheets', '#verdict-title', '#status'].map((selector) =>
            boxOf(page, selector),
          ),
        );
      const before = await places();
      await page.fill('#edge-number', '1');
      await page.locator('#edge-number').press('Enter');
      const card = await boxOf(page, '#edge-card');
      const inspector = await boxOf(page, '#inspector');
      expect(card.x).toBeGreaterThanOrEqual(inspector.x);
      expect(card.y).toBeGreaterThanOrEqual(inspector.y + inspector.height - 1);
      expect(card.y + card.height).toBeLessThanOrEqual(800);
      await page.locator('#paper').selectOption('A5');
      await page.locator('#status').getByText('Not applied yet: Paper.').waitFor();
      await page.locator('#inspector').evaluate((own) => own.scrollTo(0, 0));
      const after = await places();
      // The sheet with the edge was brought to the middle, and nothing else has moved.
      for (const index of [0, 2, 3]) expect(after[index]).toEqual(before[index]);
      expect(await page.locator('#result').isVisible()).toBe(true);
      expect(studio.complaints).toEqual([]);
    },
    { folded: true },
  ));
