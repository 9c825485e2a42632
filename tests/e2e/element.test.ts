/** `<foldwright-studio>` in plain pages that a static server hosts with the files of the build. */
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { foldwright, inFolder } from '../web/command.js';
import { objText, wavyRing } from '../web/model-text.js';
import { drag, resultIn, withElementPage } from './element-page.js';

const ring = objText(wavyRing(20));
const files = { 'shop/models/ring.obj': ring };
const pair = `
  <foldwright-studio id="one" src="models/ring.obj" parts="4" seed="3" paper="letter" lang="de"></foldwright-studio>
  <foldwright-studio id="two"></foldwright-studio>
  <p id="after">Other things to buy</p>`;

function studios(page: Page): [Locator, Locator] {
  return [page.locator('#one'), page.locator('#two')];
}

function chooseSample(studio: Locator, name: string): Promise<void> {
  return studio.getByRole('button', { name, exact: true }).click();
}

/** Drops a model of which all is in one part: bred nets of it take until they are cancelled. */
async function dropLongRun(studio: Locator): Promise<void> {
  const file = { name: 'long.obj', content: objText(wavyRing(30)) };
  await drag(studio.locator('.mat'), ['drop'], file);
  await studio.locator('#cancel').waitFor();
}

async function beginLongRun(studio: Locator): Promise<void> {
  await studio.locator('#solver').selectOption('genetic');
  await studio.locator('#parts').fill('1');
  await dropLongRun(studio);
}

/** The hash that the command line gives for what the first studio is asked for. */
function hashUnderNode(): Promise<string> {
  return inFolder(async (folder) => {
    const [model, report] = [join(folder, 'ring.obj'), join(folder, 'report.json')];
    await writeFile(model, ring);
    const options = ['--parts', '4', '--seed', '3', '--paper', 'letter'];
    const { status } = await foldwright([model, ...options, '--report', report, '--quiet']);
    expect(status).toBe(0);
    const read = JSON.parse(await readFile(report, 'utf8')) as { result_hash: string };
    return read.result_hash;
  });
}

test('two studios on a page speak languages of their own, and give the results of the command line', () =>
  withElementPage({ markup: pair, files }, async ({ page, complaints }) => {
    const [one, two] = studios(page);
    const hash = await resultIn(one, 'ring');
    expect(hash).toBe(await hashUnderNode());
    expect(await two.locator('#result').isVisible()).toBe(false);
    expect(await two.locator('#chosen').innerText()).toBe(
      'GLB, OBJ, STL, 3MF, PLY, OFF, PDO, FOLD or ZIP',
    );

    await chooseSample(two, 'House');
    expect(await resultIn(two, 'house')).not.toBe(hash);
    expect(await one.locator('#result').getAttribute('data-hash')).toBe(hash);
    expect(await one.locator('#chosen').innerText()).toBe('Gewählt: ring.obj');
    expect(await one.locator('.sample[aria-pressed="true"]').count()).toBe(0);

    // Another model and other fields, by their attributes.
    await one.evaluate((studio) => {
      studio.setAttribute('parts', 'auto');
      studio.setAttribute('paper', '300x200');
      studio.setAttribute(
        'src',
        new URL('../vendor/foldwright/samples/cube.obj', location.href).href,
      );
    });
    await resultIn(one, 'cube');
    expect(await one.locator('#result-lead').innerText()).toContain('300x200');
    expect(await one.locator('#parts').inputValue()).toBe('');
    expect(await two.locator('#paper').inputValue()).toBe('A4');
    await one.evaluate((studio) => studio.setAttribute('src', 'nothing.obj'));
    await one.locator('#message', { hasText: '„nothing.obj“ lässt sich nicht laden' }).waitFor();
    expect(await two.locator('#message').isVisible()).toBe(false);
    expect(complaints.filter((words) => !words.includes('404'))).toEqual([]);
  }));

test('a studio tells what its runs tell as events that bubble', () =>
  withElementPage(
    {
      markup: `<script>
          window.heard = [];
          addEventListener('foldwright-event', ({ target, detail }) =>
            heard.push([target.id, detail.type, detail.result?.hash]));
        </script>${pair}`,
      files,
    },
    async ({ page }) => {
      const hash = await resultIn(studios(page)[0], 'ring');
      const heard = await page.evaluate(
        () => (window as unknown as { heard: [string, string, string?][] }).heard,
      );
      expect(new Set(heard.map(([id]) => id))).toEqual(new Set(['one']));
      const types = heard.map(([, type]) => type);
      for (const type of ['stage', 'model', 'segmented', 'net']) expect(types).toContain(type);
      expect(heard.at(-1)!.slice(1)).toEqual(['done', hash]);
    },
  ));

test('styles, hatches, keyboard, keys and drops of a studio are its own', () =>
  withElementPage({ markup: pair, files }, async ({ page, complaints }) => {
    const [one, two] = studios(page);
    await resultIn(one, 'ring');
    await chooseSample(two, 'House');
    await resultIn(two, 'house');

    // Neither do the page's styles come in, nor those of the studio out.
    const look = (selector: string): Promise<string[]> =>
      page.locator(selector).evaluate((element) => {
        const { letterSpacing, textTransform, margin } = getComputedStyle(element);
        return [letterSpacing, textTransform, margin];
      });
    expect(await look('#two #result-title')).toEqual(['normal', 'none', '0px']);
    expect((await look('#after')).slice(0, 2)).toEqual(['9px', 'uppercase']);
    expect(await page.locator('#after').evaluate((own) => getComputedStyle(own).margin)).not.toBe(
      '0px',
    );
    expect(await one.locator('#message').isVisible()).toBe(false);
    const ids = await page.evaluate(() => document.querySelectorAll('[id]').length);
    expect(ids).toBe(5);

    // Sheets in the colours of the model show no parts.
    await two.locator('#print-colours').selectOption('none');
    await two.locator('.hatch').first().waitFor({ state: 'attached' });
    await two.locator('#hatch').check();
    expect(await two.locator('.hatch').first().isVisible()).toBe(true);
    expect(await one.locator('.hatch').first().isVisible()).toBe(false);
    expect(await page.evaluate(() => document.documentElement.getAttributeNames())).toEqual([
      'lang',
    ]);

    await one.locator('label[for=seed]').click();
    const focused = (studio: Locator): Promise<string | undefined> =>
      studio.evaluate(({ shadowRoot }) => shadowRoot?.activeElement?.id);
    expect([await focused(one), await focused(two)]).toEqual(['seed', undefined]);
    await page.keyboard.type('77');
    expect(await two.locator('#seed').inputValue()).toBe('');
    expect(await one.locator('.pending:visible').count()).toBe(2);
    expect(await two.locator('.pending:visible').count()).toBe(0);

    const file = { name: 'dropped.obj', content: objText(wavyRing(8)) };
    await drag(two.locator('.mat'), ['dragenter'], file);
    expect(await two.locator('#drop-veil').isVisible()).toBe(true);
    expect(await one.locator('#drop-veil').isVisible()).toBe(false);
    expect(await drag(two.locator('.mat'), ['dragover', 'drop'], file)).toHaveLength(2);
    await resultIn(two, 'dropped');
    expect(await one.locator('#result-title').innerText()).toBe('ring');
    // What is meant for a field, or for the page, is not for a studio.
    expect(await drag(one.locator('#parts'), ['dragover', 'drop'], '4')).toEqual([]);
    expect(await drag(page.locator('#after'), ['dragover', 'drop'], file)).toEqual([]);
    expect(await one.locator('#message').isVisible()).toBe(false);

    await beginLongRun(one);
    const isRunning = async (): Promise<boolean> => {
      await page.waitForTimeout(300);
      return one.locator('#cancel').isVisible();
    };
    // In the other studio, on the page, in a field.
    await two.locator('.result__head').click();
    await page.keyboard.press('Escape');
    expect(await isRunning()).toBe(true);
    await page.locator('#after').click();
    await page.keyboard.press('Escape');
    expect(await isRunning()).toBe(true);
    await one.locator('#seed').press('Escape');
    expect(await isRunning()).toBe(true);
    // A click anywhere in a studio brings the keyboard there.
    await one.locator('#progress-words').click();
    await page.keyboard.press('Escape');
    await one.locator('#progress').waitFor({ state: 'hidden', timeout: 5000 });
    // So does something that is dropped there.
    await page.locator('#after').click();
    await dropLongRun(one);
    await page.keyboard.press('Escape');
    await one.locator('#progress').waitFor({ state: 'hidden', timeout: 5000 });
    expect(complaints).toEqual([]);
  }));

test('a studio that is removed ends its run and frees its workers, and comes back afresh', () =>
  withElementPage({ markup: pair, files }, async ({ page, complaints }) => {
    const [one, two] = studios(page);
    const hash = await resultIn(one, 'ring');
    await chooseSample(two, 'House');
    await resultIn(two, 'house');
    const kinds = (): string[] =>
      page.workers().map((worker) => /\/([a-z-]+)-[^/]*$/.exec(worker.url())![1]!);
    const count = (kind: string): number => kinds().filter((name) => name === kind).length;
    await expect.poll(() => count('model-worker')).toBe(2);
    await expect.poll(() => count('picture-worker')).toBe(6);

    // An element that only changes its place keeps what it has.
    await page.evaluate(() =>
      document.querySelector('main')!.append(document.querySelector('#one')!),
    );
    expect(await one.locator('#result').getAttribute('data-hash')).toBe(hash);

    await beginLongRun(one);
    await page.evaluate(() => document.querySelector('#one')!.remove());
    await expect.poll(() => count('model-worker')).toBe(1);
    await expect.poll(() => count('picture-worker')).toBe(3);
    await expect.poll(() => count('writer-worker')).toBe(1);
    // The engine's workers are there for the other one.
    await chooseSample(two, 'Cube');
    await resultIn(two, 'cube');
    const again = await page.evaluateHandle(() => {
      const studio = document.querySelector('#two')!;
      studio.remove();
      return studio;
    });
    await expect.poll(() => kinds()).toEqual([]);

    await again.evaluate((studio) => document.body.append(studio));
    await two.locator('.sample').first().waitFor();
    expect(await two.locator('#result').isVisible()).toBe(false);
    await chooseSample(two, 'House');
    await resultIn(two, 'house');
    expect(complaints).toEqual([]);
  }));

test('a studio that has the page for itself leaves nothing on it', () =>
  withElementPage(
    {
      markup: '<foldwright-studio whole-page></foldwright-studio>',
      // Where workers cannot draw, the page has the contexts itself.
      options: {
        script: `delete HTMLCanvasElement.prototype.transferControlToOffscreen;
          const { getContext } = HTMLCanvasElement.prototype;
          window.contexts = [];
          HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
            const context = getContext.call(this, kind, ...rest);
            if (kind === 'webgl2' && context) window.contexts.push(context);
            return context;
          };`,
      },
    },
    async ({ page, complaints }) => {
      const studio = page.locator('foldwright-studio');
      const file = { name: 'ring.obj', content: ring };
      expect(await drag(page.locator('h1'), ['dragover', 'drop'], file)).toHaveLength(2);
      await resultIn(studio, 'ring');
      const lost = (): Promise<boolean[]> =>
        page.evaluate(() =>
          (window as unknown as { contexts: WebGL2RenderingContext[] }).contexts.map((context) =>
            context.isContextLost(),
          ),
        );
      await expect.poll(async () => (await lost()).length).toBe(1);
      expect(await lost()).toEqual([false]);
      await studio.evaluate((element) => element.remove());
      await expect.poll(lost).toEqual([true]);
      expect(await drag(page.locator('h1'), ['dragover', 'drop'], file)).toEqual([]);
      expect(complaints.filter((words) => !words.includes('Context Lost'))).toEqual([]);
    },
  ));

test('a page of another origin than the files of the studio can embed it', () =>
  withElementPage({ markup: pair, files, apart: true }, async (studio) => {
    const { page, requests, complaints } = studio;
    const [one, two] = studios(page);
    expect(await resultIn(one, 'ring')).toBe(await hashUnderNode());
    await chooseSample(two, 'House');
    await resultIn(two, 'house');
    await studio.drawn('#one #model-picture');
    const pictures = await two
      .locator('.sample img')
      .evaluateAll((images) => images.map((image) => (image as HTMLImageElement).naturalWidth));
    expect(Math.min(...pictures)).toBeGreaterThan(0);
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      one.getByRole('button', { name: 'PDF', exact: true }).click(),
    ]);
    expect((await readFile(await download.path())).subarray(0, 5).toString()).toBe('%PDF-');
    // Of the page's own origin are the page and the model alone.
    const own = requests.filter((address) => address.startsWith(new URL(page.url()).origin));
    expect(own.map((address) => new URL(address).pathname)).toEqual([
      '/shop/',
      '/shop/models/ring.obj',
    ]);
    expect(complaints).toEqual([]);
  }));
