/** The result before the last change, seen beside the one on the page. */
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import { phone, type StudioPage } from './studio-page.js';

const withStudio = useStudio();

async function openAndSplit(studio: StudioPage): Promise<[before: string, after: string]> {
  const { page } = studio;
  await page.fill('#parts', '4');
  await studio.choose('ring.obj', objText(wavyRing(12)));
  const before = await studio.resultOf('ring');
  expect(await page.locator('#compare').getAttribute('aria-disabled')).toBe('true');
  await page.getByRole('button', { name: /^Part 2, piece/ }).click();
  await page.getByRole('button', { name: 'Split this part' }).click();
  await page.locator(`#result:not([data-hash="${before}"])`).waitFor();
  return [before, await studio.resultOf('ring')];
}

test('two results are compared by figures and sheets, and either can be kept', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const [before, after] = await openAndSplit(studio);
    const result = page.locator('#result');
    const dialog = page.getByRole('dialog', { name: 'Before the last change, and now' });
    const compare = page.getByRole('button', { name: 'Compare with before' });

    await compare.click();
    const pieces = dialog.getByRole('row', { name: /^Pieces/ });
    expect(await pieces.getByRole('cell').allInnerTexts()).toEqual(['4', '5']);
    for (const name of ['Sheets before', 'Sheets now']) {
      const sheets = dialog.getByRole('list', { name }).locator('.sheet');
      await sheets.first().waitFor();
    }
    expect(await dialog.locator('#sheets-before [data-area]').count()).toBe(4);
    expect(await dialog.locator('#sheets-now [data-area]').count()).toBe(5);
    await studio.picture('comparison');
    await dialog.getByRole('button', { name: 'Keep it as it is now' }).click();
    await dialog.waitFor({ state: 'hidden' });
    expect(await result.getAttribute('data-hash')).toBe(after);

    await compare.click();
    await dialog.getByRole('button', { name: 'Go back to before' }).click();
    await page.locator(`#result[data-hash="${before}"]`).waitFor();
    expect(await dialog.isVisible()).toBe(false);
    // The first result has none before it.
    await page.locator('#compare[aria-disabled="true"]').waitFor();
  }));

test('a phone shows all of a comparison', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await openAndSplit(studio);
      await page.locator('#compare').click();
      const foot = page.locator('#comparison-keep');
      await foot.waitFor();
      await page.locator('#sheets-now .sheet').first().waitFor();
      const spare = await page
        .locator('#comparison')
        .evaluate(({ clientWidth, scrollWidth }) => clientWidth - scrollWidth);
      expect(spare).toBeGreaterThanOrEqual(0);
      await studio.picture('comparison-phone');
      await page.keyboard.press('Escape');
      await foot.waitFor({ state: 'hidden' });
    },
    { viewport: phone },
  ));
