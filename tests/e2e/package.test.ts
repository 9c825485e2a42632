/** The package, called by the script of a page that has its files from another origin. */
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { JSHandle, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type * as Package from '../../web/api/browser.js';
import { foldwright, inFolder } from '../web/command.js';
import { objText, wavyRing } from '../web/model-text.js';
import { withElementPage } from './element-page.js';

const ring = objText(wavyRing(10));

function foldUnderNode(): Promise<string> {
  return inFolder(async (folder) => {
    const [model, out] = [join(folder, 'ring.obj'), join(folder, 'ring.fold')];
    await writeFile(model, ring);
    const options = ['--parts', '4', '--seed', '3', '--height', '80', '--quiet'];
    expect((await foldwright([model, ...options, '-o', out])).status).toBe(0);
    return readFile(out, 'utf8');
  });
}

interface Outcome {
  fold: string;
  pdf: string;
  parts: number;
  afterSplit: number;
  afterUndo: number;
  events: string[];
}

/** Where the page has the studio, there is the package. */
async function packageAddress(page: Page): Promise<string> {
  const studio = page.locator('script[type=module]');
  return (await studio.getAttribute('src'))!.replace('foldwright-studio', 'foldwright');
}

/** The package as a script of the page imports it. */
async function packageOf(page: Page): Promise<JSHandle<typeof Package>> {
  const address = await packageAddress(page);
  // As a text, which the tests' own bundler leaves alone.
  return page.evaluateHandle(`import(${JSON.stringify(address)})`);
}

/** What a page's own script does with the package. */
async function usePackage(page: Page): Promise<Outcome> {
  return (await packageOf(page)).evaluate(async ({ open }, text) => {
    const session = await open([{ name: 'ring.obj', bytes: new TextEncoder().encode(text) }]);
    const events = new Set<string>();
    const onEvent = ({ type }: { type: string }): unknown => events.add(type);
    const { parts } = await session.run({ parts: 4, seed: 3, height: 80 }, { onEvent });
    const written = async (format: 'fold' | 'pdf'): Promise<string> =>
      new TextDecoder('latin1').decode((await session.export(format))[0]!.bytes);
    const [fold, pdf] = [await written('fold'), (await written('pdf')).slice(0, 5)];
    await session.apply({ kind: 'split', part: 1, into: 2 });
    const afterSplit = session.report.parts;
    session.undo();
    const afterUndo = session.report.parts;
    session.close();
    return { fold, pdf, parts, afterSplit, afterUndo, events: [...events].sort() };
  }, ring);
}

test('a page of another origin unfolds, edits and writes, to the bytes of the command line', () =>
  withElementPage(
    { markup: '<p id="message">A plain page</p>', apart: true },
    async ({ page, complaints }) => {
      const { fold, events, ...rest } = await usePackage(page);
      expect(rest).toEqual({ pdf: '%PDF-', parts: 4, afterSplit: 5, afterUndo: 4 });
      expect(events).toEqual(expect.arrayContaining(['stage', 'learned', 'segmented', 'done']));
      expect(fold).toBe(await foldUnderNode());
      expect(complaints).toEqual([]);
    },
  ));

test('a worker of a page unfolds as the page does', () =>
  withElementPage({ markup: '<p id="message">A plain page</p>', apart: true }, async (plain) => {
    const { page, complaints } = plain;
    const address = await packageAddress(page);
    const fold = await page.evaluate(
      ([from, text]) => {
        const script = `
          import { unfold } from ${JSON.stringify(from)};
          addEventListener('message', async ({ data }) => {
            const files = [{ name: 'ring.obj', bytes: new TextEncoder().encode(data) }];
            try {
              const unfolded = await unfold(files, { parts: 4, seed: 3, height: 80 });
              const [file] = await unfolded.export('fold');
              postMessage(new TextDecoder().decode(file.bytes));
            } catch (error) {
              postMessage(String(error));
            }
          });`;
        const blob = new Blob([script], { type: 'text/javascript' });
        const worker = new Worker(URL.createObjectURL(blob), { type: 'module' });
        return new Promise<string>((resolve, reject) => {
          worker.onmessage = ({ data }: MessageEvent<string>) => resolve(data);
          worker.onerror = ({ message }) => reject(new Error(message));
          worker.postMessage(text);
        });
      },
      [address, ring] as const,
    );
    expect(fold).toBe(await foldUnderNode());
    expect(complaints).toEqual([]);
  }));
