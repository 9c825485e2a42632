/** FOLD files in the studio: those with nets are looked at and unfolded anew, others are models or refused. */
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { foldwright, inFolder } from '../web/command.js';
import { objText, wavyRing } from '../web/model-text.js';
import { barriers } from './barriers.js';
import { withElementPage } from './element-page.js';
import { useStudio } from './studio-fixture.js';
import { phone } from './studio-page.js';

const withStudio = useStudio();

/** The worker that draws the model answers each click by and by. */
const patient = { timeout: 20_000, interval: 500 };

/** What the command line makes of a ring in three parts. */
function foldedRing(): Promise<string> {
  return inFolder(async (folder) => {
    const [model, fold] = [join(folder, 'ring.obj'), join(folder, 'ring.fold')];
    await writeFile(model, objText(wavyRing(8)));
    const ended = await foldwright([model, '--parts', '3', '-o', fold]);
    expect(ended.status).toBe(0);
    return readFile(fold, 'utf8');
  });
}

const pattern = JSON.stringify({
  file_creator: 'Origami Simulator',
  frame_classes: ['creasePattern'],
  vertices_coords: [
    [0, 0],
    [1, 0],
    [1, 1],
  ],
  faces_vertices: [[0, 1, 2]],
});

test('a FOLD file is looked at: it folds, and pieces are chosen in model and nets', async () => {
  const fold = await foldedRing();
  await withStudio(async (studio) => {
    const { page } = studio;
    let shareAcross = 0;
    await studio.drop([{ name: 'ring.fold', content: fold }]);
    const card = page.locator('#exhibit');
    await card.waitFor();
    expect(await card.innerText()).toContain('This is only a look: the model and its 3 nets');
    expect(await page.locator('#announcement').innerText()).toContain('This is only a look');
    expect(await page.locator('#exhibit-back').isHidden()).toBe(true);
    await studio.drawn('#model-picture');

    const pieces = page.locator('#exhibit-nets [data-area]');
    expect(await pieces.count()).toBe(3);
    await pieces.nth(1).click();
    expect(await pieces.nth(1).getAttribute('aria-pressed')).toBe('true');
    expect(await page.locator('#exhibit-chosen').innerText()).toMatch(/^Piece \w+ stands out\.$/);
    // Beside the model nothing is chosen, and on its way across the picture the ring is met somewhere.
    const chosen = page.locator('#exhibit-chosen');
    const { x, y, width, height } = (await page.locator('#model-picture').boundingBox())!;
    await page.mouse.click(x + 4, y + 4);
    await expect.poll(() => chosen.innerText(), patient).toBe('');
    const inNets = page.locator('#exhibit-nets [aria-pressed="true"]');
    await expect
      .poll(async () => {
        shareAcross = (shareAcross + 0.07) % 1;
        await page.mouse.click(x + shareAcross * width, y + height / 2);
        return inNets.count();
      }, patient)
      .toBe(1);
    await page.mouse.click(x + 4, y + 4);
    await expect.poll(() => chosen.innerText(), patient).toBe('');
    await pieces.nth(0).focus();
    await page.keyboard.press('Enter');
    expect(await pieces.nth(0).getAttribute('aria-pressed')).toBe('true');

    await page.locator('#folding-time').fill('0');
    expect(await page.locator('#folding-words').innerText()).not.toBe('');
    expect(await barriers(page)).toEqual([]);
    await studio.picture('exhibit');

    await page.getByRole('button', { name: 'Unfold this model anew' }).click();
    await studio.resultOf('ring');
    expect(await page.locator('#remarks').innerText()).toContain('brings 3 nets of its own');
    expect(await card.isHidden()).toBe(true);
    expect(studio.complaints).toEqual([]);
  });
});

test('who has only looked at a file goes back to the nets before', async () => {
  const fold = await foldedRing();
  await withStudio(async (studio) => {
    const { page } = studio;
    await studio.choose('box.obj', objText(wavyRing(5)));
    const hash = await studio.resultOf('box');
    await studio.choose('ring.fold', fold);
    await page.locator('#exhibit').waitFor();
    await page.getByRole('button', { name: 'Back to the nets before' }).click();
    expect(await studio.resultOf('box')).toBe(hash);
    await studio.drawn('#model-picture');
    expect(await page.locator('#undo').isHidden()).toBe(true);
    expect(studio.complaints).toEqual([]);
  });
});

test('FOLD files of other programs are unfolded, or refused with what is missing', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.choose('bird.fold', pattern);
    expect(await studio.message()).toContain(
      'only a flat crease pattern, and the folded model is missing',
    );
    await studio.choose('bird.fold', pattern.slice(0, -20));
    await expect.poll(() => studio.message()).toContain("'bird.fold' is cut off");
    const { vertices, faces } = wavyRing(5);
    const folded = {
      frame_classes: ['foldedForm'],
      vertices_coords: vertices,
      faces_vertices: faces,
    };
    await studio.choose('ring.fold', JSON.stringify(folded));
    await studio.resultOf('ring');
    expect(await page.locator('#exhibit').isHidden()).toBe(true);
    expect(studio.complaints).toEqual([]);
  }));

test('a FOLD file is looked at on a phone', async () => {
  const fold = await foldedRing();
  await withStudio(
    async (studio) => {
      const { page } = studio;
      await studio.choose('ring.fold', fold);
      await page.locator('#exhibit').waitFor();
      await studio.drawn('#model-picture');
      expect(await page.locator('#exhibit-nets [data-area]').count()).toBe(3);
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(width).toBe(phone.width);
      await studio.picture('exhibit-phone');
      expect(studio.complaints).toEqual([]);
    },
    { viewport: phone },
  );
});

test('an element takes a FOLD file by its address', async () => {
  const markup = '<foldwright-studio src="ring.fold" lang="fr"></foldwright-studio>';
  const files = { 'shop/ring.fold': await foldedRing() };
  await withElementPage({ markup, files }, async ({ page, complaints }) => {
    const card = page.locator('#exhibit');
    await card.waitFor();
    expect(await card.innerText()).toContain('Ceci est seulement pour regarder');
    expect(complaints).toEqual([]);
  });
});
