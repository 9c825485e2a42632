import { mkdir, mkdtemp, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Locator } from 'playwright-core';
import { serve } from '../../scripts/serve.mjs';
import { sharedBrowser } from './shared-browser.js';
import { StudioPage, type BrowserOptions } from './studio-page.js';

const built = fileURLToPath(new URL('../../dist/studio', import.meta.url));

/** Where the files of the studio lie on the site of a page that embeds it. */
const vendor = 'vendor/foldwright';

/** What the page has that studios must not mind: ids and styles like theirs. */
const surroundings = `
  <style>
    * { letter-spacing: 9px; text-transform: uppercase; }
    button, .sample, .card, input { display: none; }
    [hidden] { display: block !important; }
  </style>
  <main id="result"><h1 id="parts">A shop</h1></main>`;

/** No more than a page needs that has the files of the studio from an origin; the style is the page's own. */
function policyFor(origin: string): string {
  const policy = `default-src 'none'; script-src ${origin} 'wasm-unsafe-eval'; worker-src blob: ${origin};
    connect-src 'self' ${origin}; img-src ${origin} data:; style-src 'unsafe-inline'`;
  return `<meta http-equiv="Content-Security-Policy" content="${policy}" />`;
}

export interface ElementSite {
  /** Body of the page. */
  markup: string;
  /** Whether the files of the studio come from another origin than the page. */
  apart?: boolean;
  /** Other files of the page's folder. */
  files?: Record<string, string>;
  options?: BrowserOptions;
}

async function writeSite(folder: string, files: Record<string, string>): Promise<void> {
  for (const [name, content] of Object.entries(files)) {
    await mkdir(dirname(join(folder, name)), { recursive: true });
    await writeFile(join(folder, name), content);
  }
  await mkdir(dirname(join(folder, vendor)), { recursive: true });
  await symlink(built, join(folder, vendor));
}

/** Opens a plain page of a static server that embeds the element, hands it to `work` and closes it. */
export async function withElementPage(
  { markup, apart = false, files = {}, options }: ElementSite,
  work: (studio: StudioPage) => Promise<void>,
): Promise<void> {
  const folder = await mkdtemp(join(tmpdir(), 'foldwright-site-'));
  const other = apart
    ? await serve(built, { headers: { 'access-control-allow-origin': '*' } })
    : null;
  const script = `${other?.address ?? `../${vendor}/`}foldwright-studio.js`;
  const policy = other ? policyFor(new URL(other.address).origin) : '';
  const page = `<!doctype html><html lang="en"><title>A shop</title>${policy}
    <link rel="icon" href="data:," />
    <script type="module" src="${script}"></script>${surroundings}${markup}</html>`;
  await writeSite(folder, { 'shop/index.html': page, ...files });
  const server = await serve(folder);
  try {
    const studio = await StudioPage.open(`${server.address}shop/`, options, await sharedBrowser());
    await work(studio).finally(() => studio.close());
  } finally {
    server.close();
    other?.close();
    await rm(folder, { recursive: true, force: true });
  }
}

/** Waits for the result of the model with this name in one studio, and returns its hash. */
export async function resultIn(studio: Locator, name: string): Promise<string> {
  await studio.locator('#result-title', { hasText: name }).waitFor({ timeout: 60_000 });
  await studio.locator('#progress').waitFor({ state: 'hidden', timeout: 60_000 });
  await studio.locator('#sheets[aria-busy]').waitFor({ state: 'detached', timeout: 60_000 });
  return (await studio.locator('#result').getAttribute('data-hash')) ?? '';
}

/** What is dragged: a file, or a text. */
export type Dragged = { name: string; content: string } | string;

/** Drags something to an element; which of the events were taken, and so kept from the browser. */
export function drag(target: Locator, types: string[], dragged: Dragged): Promise<string[]> {
  return target.evaluate(
    (element, { names, what }) => {
      const dataTransfer = new DataTransfer();
      if (typeof what === 'string') dataTransfer.setData('text/plain', what);
      else dataTransfer.items.add(new File([what.content], what.name));
      // As those of the browser they leave shadow trees.
      const event = { dataTransfer, bubbles: true, cancelable: true, composed: true };
      return names.filter((type) => !element.dispatchEvent(new DragEvent(type, event)));
    },
    { names: types, what: dragged },
  );
}
