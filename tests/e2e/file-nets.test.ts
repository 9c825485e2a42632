/** A Pepakura file brings nets along: a person keeps them or has new ones made. */
import { expect, test } from 'vitest';
import { halvesFile, pdoFile } from '../web/pdo-files.js';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();

const { bytes } = pdoFile(halvesFile);

test('the nets of a file are offered, kept, and left again', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const check = page.locator('#check');
    await studio.choose('box.pdo', Buffer.from(bytes));
    await check.waitFor();
    const words = page.locator('#check-nets-words');
    expect(await words.innerText()).toContain('The file brings its own nets, 2 pieces.');
    await page.getByRole('button', { name: 'keep the file’s own' }).click();
    expect(await words.innerText()).toContain('cut and folded just as in its file');
    await studio.picture('file-nets');
    await check.getByRole('button', { name: 'Unfold' }).click();
    const hash = await studio.resultOf('box');
    const result = page.locator('#result-side');
    expect(await result.innerText()).toContain(
      'The 2 nets of the file were kept, at the size of the file.',
    );
    expect(await result.innerText()).toContain('30 × 30 × 30 mm');

    await page.locator('#check-again').click();
    await page.getByRole('button', { name: 'make new nets' }).click();
    await check.getByRole('button', { name: 'Unfold' }).click();
    await expect.poll(() => studio.resultOf('box')).not.toBe(hash);
    expect(await result.innerText()).toContain('The file brings 2 nets of its own');
    expect(studio.complaints).toEqual([]);
  }));

test('a locked file is refused by name', () =>
  withStudio(async (studio) => {
    await studio.choose('box.pdo', Buffer.from(pdoFile({ lock: 2 }).bytes));
    expect(await studio.message()).toContain('is locked by the person who made it');
  }));
