/** No option, word or control is cut off, however wide the window is. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { languages } from '../../web/model/languages.js';
import { loadWords } from '../../web/words/load.js';
import { objText, wavyRing } from '../web/model-text.js';
import { inLanguage } from './languages.js';
import { useStudio } from './studio-fixture.js';
import { desktop } from './studio-page.js';

const withStudio = useStudio();
const widths = [390, 768, 1366, 1440, 2560];

/** Languages with longer words are looked at on a phone and on a usual screen. */
const cases = languages.map((language) => ({
  language,
  widths: language === 'en' ? widths : [390, 1366],
}));

/** One line for each control that is wider than its place, or shows less than it holds. */
function cutOff(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    /** As wide as its longest option. */
    const wanted = (list: HTMLSelectElement): number => {
      const { width, justifySelf } = list.style;
      Object.assign(list.style, { width: 'max-content', justifySelf: 'start' });
      const { offsetWidth } = list;
      Object.assign(list.style, { width, justifySelf });
      return offsetWidth;
    };
    /** Whether a field would show the longest number that it takes. */
    const showsAll = (field: HTMLInputElement): boolean => {
      const { value } = field;
      if (field.type === 'number' && field.max !== '') field.value = field.max;
      const fits = field.scrollWidth <= field.clientWidth;
      field.value = value;
      return fits;
    };
    const frames = (element: Element): Element[] => {
      const parent = element.parentElement;
      return parent ? [parent, ...frames(parent)] : [];
    };
    const isCut = (element: HTMLElement): boolean => {
      const { left, right } = element.getBoundingClientRect();
      if (left < 0 || right > document.documentElement.clientWidth) return true;
      const sticksOut = frames(element).some((frame) => {
        const box = frame.getBoundingClientRect();
        return getComputedStyle(frame).overflowX !== 'visible' && right > box.right + 0.5;
      });
      if (sticksOut) return true;
      if (element instanceof HTMLSelectElement) return wanted(element) > element.offsetWidth;
      if (element instanceof HTMLInputElement) return !showsAll(element);
      return element.scrollWidth > element.clientWidth && element.clientWidth > 0;
    };
    const controls = 'input:not(.visually-hidden), select, button, label, summary, legend, output';
    const { shadowRoot } = document.querySelector('foldwright-studio')!;
    const seen = [...shadowRoot!.querySelectorAll<HTMLElement>(controls)].filter((element) =>
      element.checkVisibility(),
    );
    return seen
      .filter(isCut)
      .map(({ id, className, textContent }) => `${id || className} ${textContent?.slice(0, 40)}`);
  });
}

/** Every width is looked at with the same result: a run of its own would show no more. */
async function atEach(
  widths: readonly number[],
  page: Page,
  look: (width: number) => Promise<void>,
): Promise<void> {
  for (const width of widths) {
    await page.setViewportSize({ width, height: 900 });
    await look(width);
  }
}

/** What is cut off is told a moment after the window has another size. */
function expectFit(page: Page, where: string | number): Promise<void> {
  return expect
    .poll(async () => [where, ...(await cutOff(page))], { interval: 100 })
    .toEqual([where]);
}

/** The list of parts shows its last row. */
async function expectAllParts(page: Page): Promise<void> {
  const hidden = (): Promise<number> =>
    page.locator('#parts-list').evaluate((list) => list.scrollHeight - list.clientHeight);
  await expect.poll(hidden).toBe(0);
  const list = (await page.locator('#parts-list').boundingBox())!;
  const last = (await page.locator('.part-row').last().boundingBox())!;
  expect(last.y + last.height).toBeLessThanOrEqual(list.y + list.height);
}

test.each(cases)('every option and every part is to be read: $language', ({ language, widths }) =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      const { page: words } = await loadWords(language);
      await atEach(widths, page, async (width) => {
        for (const sizing of ['scale', 'sheets', 'height']) {
          await page.selectOption('#sizing', sizing);
          await expectFit(page, `${width} ${sizing}`);
        }
      });
      await page.selectOption('#sizing', 'fit');
      await page.fill('#parts', '14');
      await studio.choose('ring.obj', objText(wavyRing(12)));
      await studio.resultOf('ring');
      await page.getByText(words.look.lines).click();
      await page.getByText(words.steps.title).click();
      await page.locator('.step').first().waitFor();
      await atEach(widths, page, async (width) => {
        await expectFit(page, width);
        if (width >= 900) return;
        for (const tab of ['sheets', 'build', 'save', 'model']) {
          await page.click(`#tabs [data-tab=${tab}]`);
          await expectFit(page, `${width} ${tab}`);
        }
      });
      await page.setViewportSize(desktop);
      await expectAllParts(page);
      await page.locator('.part').first().click();
      await page.selectOption('#paper', 'Tabloid');
      await atEach(widths, page, async (width) => {
        await expectFit(page, width);
        await studio.picture(`fits-${language}-${width}`);
      });
      expect(studio.complaints).toEqual([]);
    },
    { viewport: { width: widths.at(-1)!, height: 900 }, script: inLanguage(language) },
  ),
);
