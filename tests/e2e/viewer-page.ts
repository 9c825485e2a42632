import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { serve } from '../../scripts/serve.mjs';
import { startChromium } from './chromium.js';

const built = fileURLToPath(new URL('../../dist/studio', import.meta.url));

/** No more than a page needs that has the viewer from another origin. */
function policyFor(origin: string): string {
  const policy = `default-src 'none'; script-src ${origin} 'wasm-unsafe-eval' 'unsafe-inline';
    worker-src blob: ${origin}; connect-src 'self' ${origin}; img-src 'self' ${origin} data:`;
  return `<meta http-equiv="Content-Security-Policy" content="${policy}" />`;
}

export interface ViewerPage {
  page: Page;
  /** Where the viewer's own files lie. */
  host: string;
  /** Of the viewer's own files that were asked for so far, by their names. */
  loaded: Set<string>;
  /** Errors and warnings of the console, and uncaught errors. */
  complaints: string[];
}

/** The size of what a host sends of these files of the build, compressed. */
export const builtFile = (name: string): string => join(built, name);

/** The modules of the viewer. */
const moduleOf = (host: string): string =>
  `<script type="module" src="${host}foldwright-viewer.js"></script>`;

export interface ViewerPageOptions {
  /** What loads the viewer from a host. */
  scriptOf?: (host: string) => string;
  /** Runs before the page has loaded anything. */
  prepare?: (page: Page) => Promise<void>;
}

/** Opens a plain page with viewers, whose scripts come from another origin; hands it to `work` and closes it. */
export async function withViewerPage(
  markup: string,
  files: Record<string, string>,
  work: (page: ViewerPage) => Promise<void>,
  { scriptOf = moduleOf, prepare }: ViewerPageOptions = {},
): Promise<void> {
  const folder = await mkdtemp(join(tmpdir(), 'foldwright-viewer-'));
  const host = await serve(built, { headers: { 'access-control-allow-origin': '*' } });
  const html = `<!doctype html><html lang="en"><title>A shop</title>
    ${policyFor(new URL(host.address).origin)}<link rel="icon" href="data:," />
    <script>
      window.heard = [];
      for (const type of ['load', 'unfold', 'error', 'fold-change', 'before-download', 'selection-change'])
        document.addEventListener(type, ({ detail }) => detail && heard.push({ type, ...detail }));
    </script>
    ${scriptOf(host.address)}${markup}</html>`;
  for (const [name, text] of Object.entries({ 'index.html': html, ...files })) {
    await writeFile(join(folder, name), text);
  }
  const server = await serve(folder);
  const browser = await startChromium();
  try {
    const page = await browser.newPage({ reducedMotion: 'reduce' });
    const [loaded, complaints] = [new Set<string>(), [] as string[]];
    page.on('pageerror', (error) => complaints.push(String(error)));
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
    });
    page.context().on('request', (request) => {
      const address = request.url();
      if (address.startsWith(host.address)) loaded.add(address.slice(host.address.length));
    });
    await prepare?.(page);
    await page.goto(server.address);
    await work({ page, host: host.address, loaded, complaints });
  } finally {
    await browser.close();
    server.close();
    host.close();
    await rm(folder, { recursive: true, force: true });
  }
}
