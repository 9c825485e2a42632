/** A page of a plain site with the built files in its folder `foldwright`, as the examples have them, in Chromium. */
import { cp, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { serve } from '../../scripts/serve.mjs';
import { sharedBrowser } from '../e2e/shared-browser.js';
import { inFolder } from '../web/command.js';
import { root } from '../web/packed.js';

export interface ShopPage {
  page: Page;
  /** Errors and warnings of the console, uncaught errors, and files that are not there. */
  complaints: string[];
}

/** Where examples look for models, and where these are. */
const models = {
  'whale.fold': 'build/site/models/whale.fold',
  'house.fold': 'build/site/models/house.fold',
  // Of few faces, since it is unfolded.
  'models/whale.obj': 'dist/studio/samples/house.obj',
  'models/house.mtl': 'dist/studio/samples/house.mtl',
};

/** Keeps what the page complains of from now on. */
export function listen(page: Page): string[] {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('response', (response) => {
    if (response.status() >= 400) complaints.push(`${response.url()}: ${response.status()}`);
  });
  page.on('console', (message) => {
    // What software that draws instead of a graphics card says of itself is about the machine.
    const isOfMachine = /GPU stall|swiftshader|GL Driver/i.test(message.text());
    if (['error', 'warning'].includes(message.type()) && !isOfMachine)
      complaints.push(message.text());
  });
  return complaints;
}

/** Opens a page with this markup, hands it to `work` and closes it. */
export function withShopPage(
  markup: string,
  work: (shop: ShopPage) => Promise<void>,
): Promise<void> {
  return inFolder(async (folder) => {
    await cp(join(root, 'dist/studio'), join(folder, 'foldwright'), { recursive: true });
    for (const [name, path] of Object.entries(models)) {
      await cp(join(root, path), join(folder, name));
    }
    const isWhole = markup.startsWith('<!doctype html>');
    const html = isWhole
      ? markup
      : `<!doctype html><html lang="en"><title>A shop</title>${markup}</html>`;
    // Browsers ask for an icon by themselves.
    await writeFile(join(folder, 'favicon.ico'), '');
    await writeFile(join(folder, 'index.html'), html);
    const server = await serve(folder);
    const context = await (await sharedBrowser()).newContext({ reducedMotion: 'reduce' });
    try {
      const page = await context.newPage();
      const complaints = listen(page);
      await page.addInitScript(() => {
        const heard: string[] = [];
        Object.assign(window, { heard });
        for (const type of ['load', 'error', 'foldwright-ready', 'foldwright-event']) {
          document.addEventListener(type, (event) => {
            const detail: unknown = (event as CustomEvent).detail;
            const { type: told } = (detail ?? {}) as { type?: string };
            if (event instanceof CustomEvent) heard.push(told ?? type);
          });
        }
      });
      await page.goto(server.address);
      await work({ page, complaints });
    } finally {
      await context.close();
      server.close();
    }
  });
}
