/** `<foldwright-viewer>` in a plain page, from another origin. */
import { readFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';
import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { elementsManifest } from '../../scripts/elements-manifest.mjs';
import type { FoldwrightViewer } from '../../web/element/foldwright-viewer.js';
import type { Report } from '../../web/export/report.js';
import { nodePackage } from '../web/built-package.js';
import { ring, unfoldedRing } from './unfolded-ring.js';
import { builtFile, withViewerPage } from './viewer-page.js';

/** Bytes, compressed, that a page with a finished model asks for: scripts and three.js, and no engine. */
const budget = 180_000;

/** The same without what draws the model, which is fetched once there is one. */
const shellBudget = 25_000;

type Heard = { type: string } & Record<string, unknown>;

function heard(page: Page, type: string): Promise<Heard[]> {
  return page.evaluate(
    (name) =>
      (window as unknown as { heard: Heard[] }).heard.filter((event) => event.type === name),
    type,
  );
}

async function waitFor(page: Page, type: string): Promise<Heard> {
  await page.waitForFunction(
    (name) => (window as unknown as { heard: Heard[] }).heard.some((event) => event.type === name),
    type,
    { timeout: 60_000 },
  );
  return (await heard(page, type)).at(-1)!;
}

/** Waits until the picture of the model is another one than before. */
async function pictureAfter(page: Page, before: Buffer | null): Promise<Buffer> {
  for (;;) {
    const picture = await page.locator('canvas').screenshot();
    // A blank canvas has next to no bytes.
    if (picture.length > 4000 && !before?.equals(picture)) return picture;
    await page.waitForTimeout(100);
  }
}

test('a viewer shows and folds a FOLD file without the engine, within its budget', async () => {
  const { fold } = await unfoldedRing();
  const markup = `<p><button id="after">Buy</button></p>
    <foldwright-viewer src="ring.fold" view="both" controls alt="A ring" download-formats="fold"></foldwright-viewer>`;
  await withViewerPage(markup, { 'ring.fold': fold }, async ({ page, loaded, complaints }) => {
    expect(await waitFor(page, 'load')).toMatchObject({ name: 'ring.fold', isShown: true });
    const viewer = page.locator('foldwright-viewer');
    expect(await viewer.locator('.nets svg [data-area]').count()).toBe(3);
    expect(await viewer.locator('.picture').getAttribute('aria-label')).toContain('A ring');
    const folded = await pictureAfter(page, null);

    const sizeOf = async (name: string): Promise<number> =>
      gzipSync(await readFile(builtFile(name))).length;
    const sizes = await Promise.all([...loaded].map(sizeOf));
    const shell = await Promise.all(
      [...loaded].filter((name) => !name.includes('model-worker')).map(sizeOf),
    );
    expect(shell.reduce((sum, size) => sum + size)).toBeLessThan(shellBudget);
    expect([...loaded].filter((name) => /wasm|\/worker-/.test(name))).toEqual([]);
    expect([...loaded].some((name) => name.includes('model-worker'))).toBe(true);
    expect(sizes.reduce((sum, size) => sum + size)).toBeLessThan(budget);

    await viewer.evaluate((element: FoldwrightViewer) => element.foldTo(0.3));
    expect(await viewer.evaluate((element: FoldwrightViewer) => element.fold)).toBe(0.3);
    expect(await viewer.locator('input').inputValue()).toBe('0.3');
    await pictureAfter(page, folded);

    // Keys are the viewer's only where they were meant for it.
    await page.locator('#after').focus();
    await page.keyboard.press('ArrowLeft');
    await viewer.locator('input').focus();
    await page.keyboard.press('Home');
    expect(await waitFor(page, 'fold-change')).toMatchObject({ time: 0 });

    const save = page.waitForEvent('download');
    await viewer.getByRole('button', { name: 'FOLD' }).click();
    const download = await save;
    expect(download.suggestedFilename()).toBe('ring.fold');
    expect(await readFile(await download.path(), 'utf8')).toBe(fold);
    await page.evaluate(() =>
      document.addEventListener('before-download', (event) => event.preventDefault()),
    );
    await viewer.getByRole('button', { name: 'FOLD' }).click();
    await page.waitForTimeout(300);
    expect(await heard(page, 'before-download')).toHaveLength(2);
    const refusal = await viewer.evaluate((element: FoldwrightViewer) =>
      element.exportAs('pdf').catch(({ code }: { code: string }) => code),
    );
    expect(refusal).toBe('not-written');

    // A move is no end; a removal is.
    expect(page.workers()).toHaveLength(1);
    await viewer.evaluate((element) => document.body.prepend(element));
    expect(await viewer.evaluate((element: FoldwrightViewer) => element.fold)).toBe(0);
    expect(page.workers()).toHaveLength(1);
    const left = await viewer.evaluate(async (element: FoldwrightViewer) => {
      element.remove();
      await Promise.resolve();
      return element.shadowRoot!.childElementCount;
    });
    expect(left).toBe(0);
    await expect.poll(() => page.workers().length).toBe(0);
    expect(complaints).toEqual([]);
  });
});

test('a viewer unfolds a model when it is asked to, as the command line does', async () => {
  const { hash } = await unfoldedRing();
  const markup = `<foldwright-viewer src="ring.obj" parts="3" seed="2" view="nets"></foldwright-viewer>`;
  await withViewerPage(markup, { 'ring.obj': ring }, async ({ page, loaded, complaints }) => {
    const viewer = page.locator('foldwright-viewer');
    const button = viewer.getByRole('button', { name: 'Unfold' });
    await button.waitFor();
    expect([...loaded].filter((name) => /wasm|\/worker-|engine/.test(name))).toEqual([]);
    expect(page.workers()).toHaveLength(0);

    const end = await viewer.evaluate(async (element: FoldwrightViewer) => {
      const unfolding = element.unfold().catch(({ name }: Error) => name);
      setTimeout(() => element.cancel(), 50);
      return unfolding;
    });
    expect(end).toBe('AbortError');
    await button.click();
    const { report } = await waitFor(page, 'unfold');
    expect(report).toMatchObject({ parts: 3, result_hash: hash });
    expect(await viewer.locator('.sheet svg').count()).toBeGreaterThan(0);
    const names = await viewer.evaluate(async (element: FoldwrightViewer) =>
      (await element.exportAs('pdf', { paper: 'A3' })).map(({ name }) => name),
    );
    expect(names).toEqual(['ring.pdf']);
    await viewer.evaluate((element) => element.remove());
    await expect.poll(() => page.workers().length).toBe(0);
    expect(complaints).toEqual([]);
  });
});

/** A project as the page got it, opened under node: the report of its result. */
async function reopened({ name, bytes }: SavedFile): Promise<Report> {
  const { open } = await nodePackage();
  const session = await open([{ name, bytes: Uint8Array.from(bytes) }]);
  await session.result();
  session.close();
  return session.report;
}

interface SavedFile {
  name: string;
  bytes: number[];
}

const saved = (viewer: Locator): Promise<SavedFile> =>
  viewer.evaluate(async (element: FoldwrightViewer) => {
    const { name, bytes } = await element.saveProject();
    return { name, bytes: [...bytes] };
  });

test('a viewer unfolds as its attributes ask, and saves the project before and after', async () => {
  const markup = `<foldwright-viewer src="ring.obj" parts="3" seed="2" target-size="90" flaps="4"
    view="nets"></foldwright-viewer>`;
  await withViewerPage(markup, { 'ring.obj': ring }, async ({ page, complaints }) => {
    const viewer = page.locator('foldwright-viewer');
    const asked = await reopened(await saved(viewer));
    const report = await viewer.evaluate((element: FoldwrightViewer) => {
      element.solver = 'tree';
      return element.unfold();
    });
    expect(Math.max(...report.size_mm)).toBeCloseTo(90, 3);
    expect(report.options).toMatchObject({ flaps: 4, solver: 'tree', parts: 3 });
    expect(asked.result_hash).toBe(report.result_hash);
    const file = await saved(viewer);
    expect(file.name).toBe('ring.foldwright');
    expect((await reopened(file)).result_hash).toBe(report.result_hash);

    const code = await viewer.evaluate(async (element: FoldwrightViewer) => {
      element.targetSize = 'big';
      return element.unfold().catch((error: { code: string }) => error.code);
    });
    expect(code).toBe('bad-option');
    expect(await viewer.getByRole('status').innerText()).toContain('target-size');
    expect(await viewer.getAttribute('target-size')).toBe('big');
    expect(complaints).toEqual([]);
  });
});

test('a viewer speaks the language of its attribute, and another one when that changes', async () => {
  const { fold } = await unfoldedRing();
  const markup = `<foldwright-viewer src="ring.fold" view="both" controls lang="de"></foldwright-viewer>
    <foldwright-viewer src="broken.fold" lang="ja"></foldwright-viewer>`;
  const files = { 'ring.fold': fold, 'broken.fold': '{}' };
  await withViewerPage(markup, files, async ({ page, complaints }) => {
    const [viewer, broken] = [0, 1].map((i) => page.locator('foldwright-viewer').nth(i));
    const nets = viewer!.locator('.nets');
    await expect.poll(() => nets.getAttribute('aria-label')).toContain('3 Teile zum Ausschneiden');
    await viewer!.getByRole('button', { name: 'Abspielen' }).waitFor();
    expect(await viewer!.getByRole('slider').getAttribute('aria-valuetext')).toBe('gefaltet');
    await broken!.getByRole('status').filter({ hasText: 'FOLDファイル' }).waitFor();

    await viewer!.evaluate((element: HTMLElement) => (element.lang = 'fr-CA'));
    await viewer!.getByRole('button', { name: 'Lecture' }).waitFor();
    expect(await nets.getAttribute('aria-label')).toContain('3 pièces à découper');
    await viewer!.evaluate((element) => element.removeAttribute('lang'));
    await viewer!.getByRole('button', { name: 'Play' }).waitFor();
    expect(complaints).toEqual([]);
  });
});

test('the elements have the attributes of their manifest', async () => {
  await withViewerPage('', {}, async ({ page, host }) => {
    // As a text, which the tests' own bundler leaves alone.
    await page.evaluate(`import(${JSON.stringify(`${host}foldwright-studio.js`)})`);
    for (const { declarations } of elementsManifest().modules) {
      const { tagName, attributes } = declarations[0];
      const observed = await page.evaluate(
        (tag) =>
          (customElements.get(tag) as unknown as { observedAttributes: string[] })
            .observedAttributes,
        tagName,
      );
      // The studio looks at these when it needs them.
      const others = tagName === 'foldwright-studio' ? ['autosave', 'whole-page', 'workers'] : [];
      const told = attributes.map(({ name }) => name).sort();
      expect([...observed, ...others].sort()).toEqual(told);
    }
  });
});

test('a viewer says what it cannot show, and waits to be asked', async () => {
  const markup = `<foldwright-viewer src="broken.fold"></foldwright-viewer>
    <foldwright-viewer src="missing.fold" reveal="interaction"></foldwright-viewer>`;
  await withViewerPage(markup, { 'broken.fold': '{}' }, async ({ page }) => {
    expect(await waitFor(page, 'error')).toMatchObject({ code: 'not-fold' });
    const [broken, missing] = [0, 1].map((i) => page.locator('foldwright-viewer').nth(i));
    expect(await broken!.getByRole('status').innerText()).toContain('does not hold a model');
    expect(await heard(page, 'error')).toHaveLength(1);
    await missing!.getByRole('button', { name: 'Show the model' }).click();
    await page.waitForFunction(
      () =>
        (window as unknown as { heard: Heard[] }).heard.filter((e) => e.type === 'error').length >
        1,
    );
    expect((await heard(page, 'error'))[1]).toMatchObject({ code: 'not-loaded' });
  });
});

test('one script without modules gets a page the elements that it has, now or later', async () => {
  const { fold } = await unfoldedRing();
  const markup = '<foldwright-viewer src="ring.fold" alt="A ring"></foldwright-viewer>';
  await withViewerPage(
    markup,
    { 'ring.fold': fold },
    async ({ page, loaded, complaints }) => {
      expect(await waitFor(page, 'load')).toMatchObject({ name: 'ring.fold', isShown: true });
      expect(loaded).not.toContain('foldwright-studio.js');
      await page.evaluate(() => {
        document.body.append(document.createElement('foldwright-studio'));
        return customElements.whenDefined('foldwright-studio');
      });
      await page.locator('foldwright-studio').getByText('Choose a model').first().waitFor();
      expect(complaints).toEqual([]);
    },
    { scriptOf: (host) => `<script src="${host}foldwright-elements.js"></script>` },
  );
});
