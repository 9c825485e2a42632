/** Pictures of the page for people, and the rules of accessibility that a program can check. */
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { barriers } from './barriers.js';
import { useStudio } from './studio-fixture.js';
import { desktop, phone, type StudioPage } from './studio-page.js';

const withStudio = useStudio();

/** Ms for all states of the page: each is drawn, and searched for barriers, in each of the colours. */
const patience = 300_000;

/** Windows, and what their pictures are called in light and in dark colours. */
const views = [
  { viewport: desktop, schemes: { light: 'desktop', dark: 'dark' } },
  { viewport: phone, schemes: { light: 'phone' } },
] as const;

/** Looks at the page as it is now, in each of the colours. */
async function look(studio: StudioPage, schemes: object, state: string): Promise<void> {
  const { page } = studio;
  for (const [colorScheme, name] of Object.entries(schemes) as ['light' | 'dark', string][]) {
    await page.emulateMedia({ colorScheme });
    await studio.picture(`${name}-${state}`);
    expect([name, state, ...(await barriers(page))]).toEqual([name, state]);
  }
}

test.each(views)(
  'the page is accessible and fits: $schemes.light',
  ({ viewport, schemes }) =>
    withStudio(
      async (studio) => {
        const { page } = studio;
        const isSmall = viewport === phone;
        const lookAt = (state: string): Promise<void> => look(studio, schemes, state);
        await lookAt('1-before');

        await studio.unfoldSettings();
        // Long enough to be looked at, and not to be filled in: it is folded away.
        await page.locator('#runs').evaluate((field: HTMLInputElement) => (field.value = '60000'));
        await studio.chooseSample('Cat');
        await page.locator('#how summary').click();
        for (const picture of ['#model-picture', '#matrix']) await studio.drawn(picture);
        await lookAt('2-learning');

        await page.locator('#runs').evaluate((field: HTMLInputElement) => (field.value = ''));
        // In one part the search goes on long enough for both of its pictures to be looked at.
        await page.fill('#parts', '1');
        await page.selectOption('#solver', 'genetic');
        await page.locator('#unfold').click();
        await page.locator('#net-words', { hasText: 'generation' }).waitFor();
        for (const picture of ['#net', '#chart']) await studio.drawn(picture);
        await lookAt('3-searching');

        await page.fill('#parts', '4');
        await page.selectOption('#solver', 'tree');
        await studio.chooseSample('Whale');
        await studio.resultOf('whale');
        await studio.drawn('#model-picture');
        await lookAt('4-after');

        await page.locator('.part').first().click();
        await lookAt('6-parts');
        await page.locator('.part').first().click();

        if (isSmall) await studio.showTab('Build');
        else await page.getByText('How to fold and glue it').click();
        await page.locator('.step').nth(1).click();
        await lookAt('5-steps');

        if (isSmall) await studio.showTab('Sheets');
        await page.fill('#edge-number', '1');
        await page.locator('#edge-number').press('Enter');
        await page.locator('#edge-card').waitFor();
        await lookAt('8-edge');

        await page.fill('#edge-number', 'B');
        await page.locator('#edge-number').press('Enter');
        await page.locator('#piece-card summary').click();
        await lookAt('9-piece');

        await page.keyboard.press('Escape');
        await page.locator('#print-open').click();
        await page.locator('.print-page').first().waitFor();
        await lookAt('10-print');
        await page.keyboard.press('Escape');

        await studio.choose('ring.obj', objText(wavyRing(34)));
        await page.locator('#check-look', { hasText: 'The picture has 1' }).waitFor();
        await page.getByRole('button', { name: '20 cm', exact: true }).click();
        await lookAt('7-check');
        const overflow = await page.evaluate(
          () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
        );
        expect(overflow).toBe(0);
        expect(studio.complaints).toEqual([]);
      },
      { viewport, folded: true, serviceWorkers: 'allow' },
    ),
  patience,
);
