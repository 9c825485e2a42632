/** Settings that differ from those of the result are marked until they are applied. */
import { expect, test } from 'vitest';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();

test('settings that are not applied yet are marked, and no longer once they are', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const notes = page.locator('.pending:visible span');
    const marked = (): Promise<string[]> =>
      page.locator('[data-pending]').evaluateAll((fields) => fields.map(({ id }) => id));
    // Without a result there is nothing that they could differ from.
    await page.selectOption('#paper', 'A3');
    expect(await notes.count()).toBe(0);
    await studio.chooseSample('Heart');
    await studio.resultOf('heart');
    expect(await notes.count()).toBe(0);

    await page.fill('#parts', '3');
    await page.selectOption('#paper', 'A5');
    expect(await marked()).toEqual(['parts', 'paper']);
    expect(await notes.allInnerTexts()).toEqual(
      new Array(2).fill('Not applied yet: Parts and Paper.'),
    );
    await page.fill('#parts', '');
    await page.selectOption('#paper', 'A3');
    expect(await marked()).toEqual([]);
    expect(await notes.count()).toBe(0);
    // What an empty field means is no change.
    await page.fill('#seed', '1');
    expect(await marked()).toEqual([]);

    await page.selectOption('#sizing', 'height');
    expect(await marked()).toEqual(['sizing', 'size']);
    await page.selectOption('#sizing', 'fit');
    expect(await marked()).toEqual([]);

    await page.selectOption('#paper', 'A5');
    await page.getByRole('button', { name: 'Apply and unfold again' }).click();
    await page.locator('#result-lead', { hasText: 'of A5' }).waitFor();
    await studio.resultOf('heart');
    expect(await notes.count()).toBe(0);
    expect(studio.complaints).toEqual([]);
  }));

test('parts that do not touch are not offered to be merged', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    // Two tetrahedra side by side: each is a part at least.
    const corners = ['0 0 0', '1 0 0', '0 1 0', '0 0 1', '5 0 0', '6 0 0', '5 1 0', '5 0 1'];
    const faces = ['1 3 2', '1 2 4', '2 3 4', '1 4 3', '5 7 6', '5 6 8', '6 7 8', '5 8 7'];
    const lines = [...corners.map((at) => `v ${at}`), ...faces.map((face) => `f ${face}`)];
    await page.fill('#parts', '2');
    await studio.choose('two.obj', lines.join('\n'));
    await studio.resultOf('two');
    await page.locator('.part').nth(0).click();
    expect(await page.getByText('Only parts that touch').isVisible()).toBe(false);
    await page.locator('.part').nth(1).click();
    expect(await page.locator('#merge').getAttribute('aria-disabled')).toBe('true');
    expect(await page.getByText('Only parts that touch').isVisible()).toBe(true);
  }));
