/** A corrected model takes the place of the one on the page, with the edits that fit. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { kept, untilKept } from './kept-work.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

const ring = wavyRing(10);

/** The ring with a spike: its vertex that is farthest along x goes farther out. */
function spikedRing(): string {
  const vertices = ring.vertices.map((point) => [...point]);
  const far = vertices.reduce((best, point) => (point[0]! > best[0]! ? point : best));
  far[0]! += 15;
  return objText({ ...ring, vertices });
}

async function replace({ page }: StudioPage, name: string, text: string): Promise<void> {
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    page.getByRole('button', { name: 'Replace the model' }).click(),
  ]);
  const mimeType = 'application/octet-stream';
  await chooser.setFiles({ name, mimeType, buffer: Buffer.from(text) });
}

const nameField = (page: Page) =>
  page.getByRole('textbox', { name: 'Name of part 1', exact: true });

/** Names the first part, and waits until it is called so. */
async function nameFirst(page: Page, name: string): Promise<void> {
  const field = nameField(page);
  await field.fill(name);
  await field.press('Enter');
  await page.locator('#undo', { hasText: 'name of part 1' }).waitFor();
}

async function openRing(studio: StudioPage): Promise<string> {
  await studio.page.fill('#parts', '3');
  await studio.choose('ring.obj', objText(ring));
  return studio.resultOf('ring');
}

test('the same surface in another file keeps all edits, and one undo brings the old one back', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const replaceButton = page.getByRole('button', { name: 'Replace the model' });
    expect(await replaceButton.isHidden()).toBe(true);
    await openRing(studio);
    await nameFirst(page, 'Head');
    const before = await studio.resultOf('ring');
    const last = ring.vertices.length - 1;
    const turned = {
      vertices: [...ring.vertices].reverse(),
      faces: ring.faces.map((face) => face.map((vertex) => last - vertex)),
    };
    await replace(studio, 'ring-2.obj', objText(turned));
    await studio.resultOf('ring-2');
    expect(await page.locator('#message').isHidden()).toBe(true);
    expect(await nameField(page).inputValue()).toBe('Head');
    expect(await page.locator('#chosen').innerText()).toBe('Chosen: ring-2.obj');
    await studio.picture('replaced');

    await page.getByRole('button', { name: 'Undo: replacing the model' }).click();
    expect(await studio.resultOf('ring')).toBe(before);
    expect(await page.locator('#chosen').innerText()).toBe('Chosen: ring.obj');
    expect(await page.locator('#undo').innerText()).toBe('Undo: name of part 1');
    await page.getByRole('button', { name: 'Redo: replacing the model' }).click();
    await studio.resultOf('ring-2');
    expect(studio.complaints).toEqual([]);
  }));

test('edits that do not fit are named with their reasons', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await openRing(studio);
    await nameFirst(page, 'Head');
    const before = await studio.resultOf('ring');
    const small = wavyRing(4);
    const half = { ...small, faces: small.faces.slice(0, 16) };
    await replace(studio, 'half.obj', objText(half));
    await studio.resultOf('half');
    expect(await studio.message()).toBe(
      '1 change did not fit the new model\n\nName of part 1: there is no such part there any more.',
    );
    await page.getByRole('button', { name: 'Undo: replacing the model' }).click();
    expect(await studio.resultOf('ring')).toBe(before);
    expect(studio.complaints).toEqual([]);
  }));

test('what is no model leaves all as it is, and both works are kept', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await openRing(studio);
    await nameFirst(page, 'Head');
    const before = await studio.resultOf('ring');
    await replace(studio, 'letter.txt', 'Dear Sir or Madam');
    expect(await studio.message()).toContain('“letter.txt” could not be unfolded');
    expect(await studio.resultOf('ring')).toBe(before);
    expect(await page.locator('#chosen').innerText()).toBe('Chosen: ring.obj');
    await replace(studio, 'spiked.obj', spikedRing());
    const after = await studio.resultOf('spiked');
    await untilKept(page, (works) => works.length === 2);
    await page.getByRole('button', { name: 'Undo: replacing the model' }).click();
    await studio.resultOf('ring');
    // However soon the other one has gone again, its result is kept.
    await untilKept(page, (works) => works.every(({ hashes, cursor }) => hashes[cursor]));
    const hashes = (await kept(page)).map((work) => work.hashes[work.cursor]);
    expect(hashes.sort()).toEqual([before, after].sort());
    expect(studio.complaints).toEqual([]);
  }));
