/** The finished model unfolds into its nets and comes together again, by hand and by itself. */
import { validateBytes } from 'gltf-validator';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

const slider = (page: Page) => page.locator('#folding-time');

/** In two parts, so that there is something to be joined. */
async function open(studio: StudioPage, sample = 'Heart'): Promise<void> {
  await studio.page.fill('#parts', '2');
  await studio.chooseSample(sample);
  await studio.resultOf(sample.toLowerCase());
  await studio.drawn('#model-picture');
}

/** The picture of the model once it has come to rest. */
async function restingPicture({ page }: StudioPage): Promise<string> {
  const shoot = async () => (await page.locator('#model-picture').screenshot()).toString('base64');
  let picture = await shoot();
  for (;;) {
    await page.waitForTimeout(500);
    const next = await shoot();
    if (next === picture) return picture;
    picture = next;
  }
}

async function pictureAt(studio: StudioPage, time: number): Promise<string> {
  await slider(studio.page).fill(String(time));
  return restingPicture(studio);
}

test('the slider shows nets, folds, pieces and the model', () =>
  withStudio(async (studio) => {
    await open(studio);
    const model = await restingPicture(studio);
    const words = () => studio.page.locator('#folding-words').innerText();
    const seen = new Map<string, string>();
    for (const time of [0, 0.35, 0.7, 0.85]) seen.set(await pictureAt(studio, time), await words());
    expect([...seen.values()]).toEqual([
      'flat',
      'folded by 50 %',
      'folded',
      expect.stringMatching(/^joining piece [AB]$/),
    ]);
    expect(seen.has(model)).toBe(false);
    expect(await pictureAt(studio, 1)).toBe(model);
    expect(await words()).toBe('the model');
    await pictureAt(studio, 0);
    await studio.picture('folding');
    expect(studio.complaints).toEqual([]);
  }));

test('keys move the slider and press the button', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    await slider(page).focus();
    await page.keyboard.press('Home');
    expect(await slider(page).getAttribute('aria-valuetext')).toBe('flat');
    await page.keyboard.press('ArrowRight');
    expect(await slider(page).getAttribute('aria-valuetext')).toMatch(/^folded by \d %$/);
    // Past the button that goes one step back.
    await page.keyboard.press('Tab');
    await page.keyboard.press('Tab');
    await page.keyboard.press('Space');
    await page.getByRole('button', { name: 'Pause', exact: true }).waitFor();
    await expect
      .poll(() => slider(page).inputValue().then(Number), { timeout: 10_000 })
      .toBeGreaterThan(0.1);
    await page.keyboard.press('Space');
    const value = await slider(page).inputValue();
    await page.waitForTimeout(500);
    expect(await slider(page).inputValue()).toBe(value);
    expect(studio.complaints).toEqual([]);
  }));

test('playing begins with the nets, ends with the model, and starts only when asked for', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await open(studio);
      await page.waitForTimeout(500);
      expect(await slider(page).inputValue()).toBe('1');
      await page.getByRole('button', { name: 'Play', exact: true }).click();
      expect(Number(await slider(page).inputValue())).toBeLessThan(0.5);
      await page.locator('#folding-words', { hasText: 'the model' }).waitFor({ timeout: 60_000 });
      await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
      expect(studio.complaints).toEqual([]);
    },
    { reducedMotion: 'no-preference' },
  ));

test('the next run takes the folding away and brings its own', () =>
  withStudio(async (studio) => {
    await open(studio);
    await pictureAt(studio, 0);
    await open(studio, 'House');
    expect(await slider(studio.page).inputValue()).toBe('1');
    const model = await restingPicture(studio);
    expect(await pictureAt(studio, 0)).not.toBe(model);
    expect(studio.complaints).toEqual([]);
  }));

test('steps point at what they are about', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    await page.getByText('How to fold and glue it').click();
    const steps = page.locator('.step');
    await steps.first().waitFor();
    expect(await steps.count()).toBe(2);
    await steps.last().click();
    expect(await steps.last().getAttribute('aria-pressed')).toBe('true');
    expect(await steps.last().innerText()).toMatch(/Glue it to [AB] along \d+ edges\./);
    // Each edge of the border in both pieces.
    const borders = await page.locator('.sheet .mark--border').count();
    expect(borders).toBeGreaterThan(0);
    expect(borders % 2).toBe(0);
    expect(await slider(page).inputValue()).toBe('1');
    await steps.last().click();
    expect(await page.locator('.sheet .mark').count()).toBe(0);
    expect(studio.complaints).toEqual([]);
  }));

test('ticks, keys and buttons lead from step to step', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    const words = page.locator('#folding-words');
    const heard = async (act: () => Promise<void>): Promise<string> => {
      await act();
      return words.innerText();
    };
    const [back, on] = [page.locator('#folding-back'), page.locator('#folding-on')];
    const inPlace = /^piece [AB] is in place$/;
    expect(await heard(() => back.click())).toMatch(inPlace);
    expect(await heard(() => back.click())).toBe('folded');
    expect(await heard(() => back.click())).toBe('flat');
    expect(await back.getAttribute('aria-disabled')).toBe('true');
    expect(await heard(() => back.press('Enter'))).toBe('flat');
    await slider(page).focus();
    expect(await heard(() => page.keyboard.press('PageUp'))).toBe('folded');
    expect(await heard(() => page.keyboard.press('PageUp'))).toMatch(inPlace);
    expect(await heard(() => page.keyboard.press('PageDown'))).toBe('folded');
    expect(await heard(() => on.click())).toMatch(inPlace);
    const ticks = page.locator('.folding__tick');
    expect(await ticks.count()).toBe(4);
    expect(await page.locator('.folding__tick[data-done]').count()).toBe(3);
    const row = (await page.locator('#folding-ticks').boundingBox())!;
    const second = (await ticks.nth(1).boundingBox())!;
    // Beside the tick is near enough.
    const position = { x: second.x - row.x - 6, y: row.height / 2 };
    expect(await heard(() => page.locator('#folding-ticks').click({ position }))).toBe('folded');
    expect(studio.complaints).toEqual([]);
  }));

test('steps are ticked off one by one, and that survives a reload', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const tick = (name: string) => page.getByRole('checkbox', { name: `Piece ${name} is done` });
    await open(studio);
    await page.getByText('How to fold and glue it').click();
    await tick('A').check();
    expect(await page.locator('#steps-count').innerText()).toBe('1 of 2 done');
    await page.reload();
    await page.locator('.sample').first().waitFor();
    await studio.unfoldSettings();
    await open(studio);
    expect(await page.locator('#steps-count').innerText()).toBe('1 of 2 done');
    await page.getByText('How to fold and glue it').click();
    expect([await tick('A').isChecked(), await tick('B').isChecked()]).toEqual([true, false]);
    // Another result has steps of its own.
    await open(studio, 'House');
    expect(await page.locator('#steps-count').innerText()).toBe('');
    await open(studio);
    await tick('A').uncheck();
    expect(await page.locator('#steps-count').innerText()).toBe('');
    expect(studio.complaints).toEqual([]);
  }));

test('a step is marked on the model, too', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    const model = await restingPicture(studio);
    await page.getByText('How to fold and glue it').click();
    // The last one leads to the whole model.
    await page.locator('.step').last().click();
    expect(await slider(page).inputValue()).toBe('1');
    const marked = await restingPicture(studio);
    expect(marked).not.toBe(model);
    await page.locator('.step').last().click();
    expect(await restingPicture(studio)).toBe(model);
    expect(studio.complaints).toEqual([]);
  }));

test('the animation can be taken along', () =>
  withStudio(async (studio) => {
    await open(studio);
    const { name, bytes } = await studio.download('Folding animation (GLB)');
    expect(name).toBe('heart.glb');
    const { issues } = await validateBytes(new Uint8Array(bytes));
    expect(issues.messages).toEqual([]);
  }));

test('pieces whose motion nobody looked for are shown with a warning', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.selectOption('#folding-mode', 'off');
    await open(studio, 'House');
    await page.getByText('faces may pass through each other').waitFor();
    await pictureAt(studio, 0.35);
    expect(studio.complaints).toEqual([]);
  }));
