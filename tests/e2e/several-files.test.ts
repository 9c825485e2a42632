/** Files that belong to a model come along with it, however they are chosen. */
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

const ring = objText(wavyRing(6));
const files = [
  { name: 'ring.mtl', content: 'newmtl wood\nmap_Kd wood.png\n' },
  { name: 'ring.obj', content: ring },
  { name: 'wood.png', content: '\x89PNG' },
];

async function hashAlone(studio: StudioPage): Promise<string> {
  await studio.choose('alone.obj', ring);
  return studio.resultOf('alone');
}

async function expectRing(studio: StudioPage, hash: string): Promise<void> {
  expect(await studio.resultOf('ring')).toBe(hash);
  expect(await studio.page.locator('#chosen').innerText()).toBe('Chosen: ring.obj');
  const words = 'other files were not needed: ring.mtl and';
  expect(await studio.page.locator('#result-side').innerText()).toContain(words);
}

test('several files are picked together', () =>
  withStudio(async (studio) => {
    const hash = await hashAlone(studio);
    await studio.chooseTogether(files);
    await expectRing(studio, hash);
    expect((await studio.download('FOLD')).name).toBe('ring.fold');
    expect(studio.complaints).toEqual([]);
  }));

test('several files are dropped together, and contents go before endings', () =>
  withStudio(async (studio) => {
    const hash = await hashAlone(studio);
    await studio.drop(files);
    await expectRing(studio, hash);
    await studio.drop([
      { name: 'notes.obj', content: 'Dear Sir or Madam' },
      { name: 'figure.txt', content: ring },
    ]);
    expect(await studio.resultOf('figure')).toBe(hash);
    expect(await studio.page.locator('#chosen').innerText()).toBe('Chosen: figure.txt');
    expect(studio.complaints).toEqual([]);
  }));

test('a folder is dropped', () =>
  withStudio(async (studio) => {
    const hash = await hashAlone(studio);
    const folder = await mkdtemp(join(tmpdir(), 'foldwright-drop-'));
    try {
      await mkdir(join(folder, 'textures'));
      for (const { name, content } of files) {
        const path = name.endsWith('.png') ? join('textures', name) : name;
        await writeFile(join(folder, path), content);
      }
      await studio.dropFolder(folder);
      await expectRing(studio, hash);
      const words = await studio.page.locator('#result-side').innerText();
      expect(words).toContain('textures/wood.png');
    } finally {
      await rm(folder, { recursive: true });
    }
    expect(studio.complaints).toEqual([]);
  }));
