import { expect } from 'vitest';
import { coloursIn } from './colours.js';
import type { WatchedStudio } from './watched-studio.js';

/** A picture that shows nothing has one colour; edges smoothed by the browser make many. */
const few = 20;

/**
 * Uses all elements of `serveEmbedding`'s page: a viewer shows a model, another one unfolds it, and the studio unfolds
 * a sample and saves it, with nothing that the page's policy forbids.
 *
 * @param hash of the result that the viewer must come to
 */
export async function useEmbedded(studio: WatchedStudio, hash: string): Promise<void> {
  const { page } = studio;
  await studio.poll('picture in the viewer', async () => {
    const box = await page.evaluate(() => {
      const viewer = document.querySelector('foldwright-viewer')!;
      const { x, y, width, height } = viewer.getBoundingClientRect();
      // Without its controls, which have colours of their own.
      return { x, y, width, height: height / 2 };
    });
    return coloursIn(await page.screenshot(), box) > few ? true : null;
  });
  const unfolded = await page.evaluate(async () => {
    const report = await document.querySelectorAll('foldwright-viewer')[1]!.unfold();
    return report.result_hash;
  });
  expect(unfolded).toBe(hash);
  await studio.click('.sample', 'House');
  expect(await studio.result()).not.toBe('');
  const { bytes } = await studio.save('pdf');
  expect(Buffer.from(bytes.subarray(0, 5)).toString()).toBe('%PDF-');
  expect(await studio.complaints()).toEqual([]);
}
