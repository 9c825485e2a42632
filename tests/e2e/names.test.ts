/** Parts are named in place, and everything that names them follows. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import { phone, type StudioPage } from './studio-page.js';

const withStudio = useStudio();

const field = (page: Page, part: number) =>
  page.getByRole('textbox', { name: `Name of part ${part}`, exact: true });
/** The button of a part that is one piece of this name. */
const part = (page: Page, number: number, piece: string) =>
  page.getByRole('button', { name: new RegExp(`^Part ${number} ?, piece ${piece}$`) });

/** Which piece each part has, as the list says. */
const list = (page: Page): Promise<string[]> =>
  page.locator('.part').evaluateAll((buttons) => buttons.map(({ textContent }) => textContent));

const textsOnSheets = (page: Page): Promise<string[]> =>
  page
    .locator('.sheet svg text')
    .evaluateAll((texts) => texts.map(({ textContent }) => textContent));

/** The outlines of all pieces where they lie. */
const outlines = (page: Page): Promise<string[]> =>
  page
    .locator('.sheet [data-area]')
    .evaluateAll((areas) => areas.map((area) => area.getAttribute('d') ?? ''));

async function open(studio: StudioPage): Promise<void> {
  await studio.page.fill('#parts', '4');
  await studio.choose('ring.obj', objText(wavyRing(12)));
  await studio.resultOf('ring');
}

/** Waits for a result of so many parts. */
const partsAre = (page: Page, count: number): Promise<void> =>
  page.locator('#result-lead', { hasText: new RegExp(`^${count} parts`) }).waitFor();

test('a name takes the place of a letter everywhere, and moves no piece', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    const [before, places] = [await list(page), await outlines(page)];
    const letter = before[1]!.replace('Part 2, piece ', '');
    expect(await textsOnSheets(page)).toContain(letter);

    await field(page, 2).fill('Wing');
    await field(page, 2).press('Enter');
    await part(page, 2, 'Wing').waitFor();
    expect(await field(page, 2).evaluate((own) => own.matches(':focus'))).toBe(true);
    expect(await outlines(page)).toEqual(places);
    const texts = await textsOnSheets(page);
    expect(texts).toContain('Wing');
    expect(texts.filter((text) => /^Wing:\d+$/.test(text))).not.toHaveLength(0);
    expect(texts.filter((text) => new RegExp(`^${letter}(:\\d+)?$`).test(text))).toEqual([]);
    expect(await page.locator('#announcement').innerText()).toBe('Named Wing.');
    await page.getByText('How to fold and glue it').click();
    await page.locator('#steps').getByText('Piece Wing:').first().waitFor();
    expect((await studio.download('FOLD')).bytes.toString()).toContain('"Piece Wing"');
    await studio.picture('names');

    // A name that is not entered is taken back.
    await field(page, 2).fill('Fin');
    await field(page, 2).press('Escape');
    expect(await field(page, 2).inputValue()).toBe('Wing');
    await field(page, 2).blur();

    await field(page, 2).fill('');
    await field(page, 2).blur();
    await part(page, 2, letter).waitFor();
    expect(await outlines(page)).toEqual(places);
    await page.getByRole('button', { name: 'Undo: name of part 2' }).click();
    await part(page, 2, 'Wing').waitFor();
    expect(studio.complaints).toEqual([]);
  }));

test('names stay with their parts when others change, and go with the model', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    await field(page, 2).fill('Wing');
    // Whoever presses a button at once does not lose the name.
    await page.locator('.part').nth(2).click();
    await page.locator('#split').click();
    await partsAre(page, 5);
    await part(page, 2, 'Wing').waitFor();
    await page.getByRole('button', { name: 'Undo: split of part 3' }).click();
    await partsAre(page, 4);
    await part(page, 2, 'Wing').waitFor();

    // A part that is split is no more.
    await page.locator('.part').nth(1).click();
    await page.locator('#split').click();
    await partsAre(page, 5);
    expect(await field(page, 2).inputValue()).toBe('');
    await page.getByRole('button', { name: 'Undo: split of part 2' }).click();
    await partsAre(page, 4);
    expect(await field(page, 2).inputValue()).toBe('Wing');

    await studio.choose('band.obj', objText(wavyRing(8)));
    await studio.resultOf('band');
    const fields = page.locator('.part__name');
    expect(
      await fields.evaluateAll((all: HTMLInputElement[]) => all.map((one) => one.value)),
    ).toEqual(Array.from({ length: await fields.count() }, () => ''));
    expect(await page.locator('#undo').isHidden()).toBe(true);
    expect(studio.complaints).toEqual([]);
  }));

test('one name after the other is typed on a phone, and a bad one is explained', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await open(studio);
      await field(page, 1).focus();
      await page.keyboard.type('Head');
      // The next name does not wait for the one before.
      await page.keyboard.press('Tab');
      await page.keyboard.press('Tab');
      await page.keyboard.type('Tail');
      await page.keyboard.press('Enter');
      await part(page, 1, 'Head').waitFor();
      await part(page, 2, 'Tail').waitFor();

      const fault = page.locator('#name-fault');
      await field(page, 3).fill('a name that is far too long');
      await field(page, 3).press('Enter');
      await fault.waitFor();
      expect(await fault.innerText()).toBe(
        'The name of a part must have 1 to 16 characters, and no space around them.',
      );
      expect(await field(page, 3).getAttribute('aria-invalid')).toBe('true');
      await studio.picture('names-phone');
      await field(page, 3).fill('Tail');
      await field(page, 3).press('Enter');
      await fault.filter({ hasText: 'Two parts cannot have the same name, "Tail".' }).waitFor();
      await field(page, 3).press('Escape');
      expect(await field(page, 3).getAttribute('aria-invalid')).toBeNull();
      expect((await list(page)).slice(0, 2)).toEqual(['Part 1, piece Head', 'Part 2, piece Tail']);
      expect(studio.complaints).toEqual([]);
    },
    { viewport: phone },
  ));
