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

    await studio.choose('ring.obj', objText(wavyRing(60)));
    await page.getByText('unfoldings tried').waitFor();
    await studio.picture(`${name}-2-during`);
    expect(await barriers(page)).toEqual([]);

    await studio.chooseSample('Whale');
    await studio.resultOf('whale');
    await studio.picture(`${name}-3-after`);
    expect(await barriers(page)).toEqual([]);
    const overflow = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    expect(overflow).toBe(0);
    expect(studio.complaints).toEqual([]);
  }, options),
);
