/** The workers of the page: any number gives the bits of the command line, whatever happens. */
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { foldwright, inFolder } from '../web/command.js';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();
const ring = objText(wavyRing(20));
const parts = '4';

async function reopen(studio: StudioPage, workers: number): Promise<void> {
  const { page } = studio;
  const address = new URL(page.url());
  address.search = `workers=${workers}`;
  await page.goto(address.href);
  await page.locator('.sample').first().waitFor();
  await studio.unfoldSettings();
}

/** The hash of the command line's result for the ring. */
function hashUnderNode(): Promise<string> {
  return inFolder(async (folder) => {
    const [model, report] = [join(folder, 'ring.obj'), join(folder, 'report.json')];
    await writeFile(model, ring);
    const { status } = await foldwright([model, '--parts', parts, '--report', report, '--quiet']);
    expect(status).toBe(0);
    const read = JSON.parse(await readFile(report, 'utf8')) as { result_hash: string };
    return read.result_hash;
  });
}

test('one, two and four workers give the result of the command line', () =>
  withStudio(async (studio) => {
    const expected = await hashUnderNode();
    for (const workers of [1, 2, 4]) {
      await reopen(studio, workers);
      await studio.page.fill('#parts', parts);
      await studio.choose('ring.obj', ring);
      expect([workers, await studio.resultOf('ring')]).toEqual([workers, expected]);
    }
    expect(studio.complaints).toEqual([]);
  }));

test('a helper that dies in the middle changes nothing', () =>
  withStudio(async (studio) => {
    const expected = await hashUnderNode();
    const { page } = studio;
    await reopen(studio, 2);
    await page.fill('#parts', parts);
    // Pictures are drawn by workers of other kinds.
    const isEngine = (worker: { url(): string }): boolean => worker.url().includes('/worker-');
    // The conductor comes first, and may be there already.
    let count = page.workers().filter(isEngine).length;
    const helper = new Promise<void>((resolve, reject) => {
      page.on('worker', (worker) => {
        if (!isEngine(worker) || ++count !== 2) return;
        worker
          .evaluate(() => {
            setTimeout(() => {
              throw new Error('killed');
            }, 100);
          })
          .then(resolve, reject);
      });
    });
    await studio.choose('ring.obj', ring);
    await helper;
    expect(await studio.resultOf('ring')).toBe(expected);
  }));
