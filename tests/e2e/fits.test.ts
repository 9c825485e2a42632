/** No option, word or control is cut off, however wide the window is. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();
const widths = [390, 768, 1366, 1440, 2560];

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

test.each(widths)('every option is to be read in a window %i px wide', (width) =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await page.getByText('More options').click();
      for (const sizing of ['scale', 'sheets', 'height']) {
        await page.selectOption('#sizing', sizing);
        expect([sizing, await cutOff(page)]).toEqual([sizing, []]);
      }
      await page.selectOption('#sizing', 'fit');
      await page.fill('#parts', '14');
      await studio.choose('ring.obj', objText(wavyRing(12)));
      await studio.resultOf('ring');
      await page.getByText('Colours, widths and dashes').click();
      await page.getByText('How to fold and glue it').click();
      expect(await cutOff(page)).toEqual([]);
      await page.locator('.part').first().click();
      await page.selectOption('#paper', 'Tabloid');
      expect(await cutOff(page)).toEqual([]);
      await studio.picture(`fits-${width}`);
      expect(studio.complaints).toEqual([]);
    },
    { viewport: { width, height: 900 } },
  ),
);

test('the list of parts shows its last row', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '14');
    await studio.choose('ring.obj', objText(wavyRing(12)));
    await studio.resultOf('ring');
    const hidden = await page
      .locator('#parts-list')
      .evaluate((list) => list.scrollHeight - list.clientHeight);
    expect(hidden).toBe(0);
    const list = (await page.locator('#parts-list').boundingBox())!;
    const last = (await page.locator('.part-row').last().boundingBox())!;
    expect(last.y + last.height).toBeLessThanOrEqual(list.y + list.height);
  }));
