/** Pictures of the page for people, and the rules of accessibility that a program can check. */
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import type { AxeResults } from 'axe-core';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import { desktop, phone } from './studio-page.js';

const withStudio = useStudio();
const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** One line for each rule that the page breaks now. */
async function barriers(page: Page): Promise<string[]> {
  // Evaluated by the debugger: the page's own policy lets no foreign script in.
  await page.evaluate(await readFile(axe, 'utf8'));
  const { violations } = await page.evaluate(() =>
    (window as unknown as { axe: { run(): Promise<AxeResults> } }).axe.run(),
  );
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`);
}

const views = [
  { name: 'desktop', viewport: desktop, colorScheme: 'light' },
  { name: 'dark', viewport: desktop, colorScheme: 'dark' },
  { name: 'phone', viewport: phone, colorScheme: 'light' },
] as const;

test.each(views)('the page is accessible and fits: $name', ({ name, ...options }) =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.picture(`${name}-1-before`);
    expect(await barriers(page)).toEqual([]);

    // Long enough to be looked at, and not to be filled in: it is folded away.
    await page.locator('#runs').evaluate((field: HTMLInputElement) => (field.value = '60000'));
    await studio.chooseSample('Cat');
    for (const picture of ['#model-picture', '#matrix']) await studio.drawn(picture);
    await studio.picture(`${name}-2-learning`);
    expect(await barriers(page)).toEqual([]);

    await page.locator('#runs').evaluate((field: HTMLInputElement) => (field.value = ''));
    // In one part the search goes on long enough for both of its pictures to be looked at.
    await page.fill('#parts', '1');
    await page.selectOption('#solver', 'genetic');
    await page.locator('#unfold').click();
    await page.locator('#net-words', { hasText: 'generation' }).waitFor();
    for (const picture of ['#net', '#chart']) await studio.drawn(picture);
    await studio.picture(`${name}-3-searching`);
    expect(await barriers(page)).toEqual([]);

    await page.fill('#parts', '4');
    await page.selectOption('#solver', 'tree');
    await studio.chooseSample('Whale');
    await studio.resultOf('whale');
    await studio.drawn('#model-picture');
    await studio.picture(`${name}-4-after`);
    expect(await barriers(page)).toEqual([]);

    await page.locator('.part').first().click();
    await studio.picture(`${name}-6-parts`);
    expect(await barriers(page)).toEqual([]);
    await page.locator('.part').first().click();

    await page.getByText('How to fold and glue it').click();
    await page.locator('.step').nth(1).click();
    await studio.picture(`${name}-5-steps`);
    expect(await barriers(page)).toEqual([]);

    await page.fill('#edge-number', '1');
    await page.locator('#edge-number').press('Enter');
    await page.locator('#edge-card').waitFor();
    await studio.picture(`${name}-8-edge`);
    expect(await barriers(page)).toEqual([]);

    await page.fill('#edge-number', 'B');
    await page.locator('#edge-number').press('Enter');
    await page.locator('#piece-card summary').click();
    await studio.picture(`${name}-9-piece`);
    expect(await barriers(page)).toEqual([]);

    await studio.choose('ring.obj', objText(wavyRing(34)));
    await page.locator('#check-look', { hasText: 'The picture has 1' }).waitFor();
    await page.getByRole('button', { name: '20 cm', exact: true }).click();
    await studio.picture(`${name}-7-check`);
    expect(await barriers(page)).toEqual([]);
    const overflow = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    expect(overflow).toBe(0);
    expect(studio.complaints).toEqual([]);
  }, options),
);
