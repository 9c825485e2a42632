/** A page that uses all of the package, for bundlers to bundle. */
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect } from 'vitest';
import { serve } from '../../scripts/serve.mjs';
import { sharedBrowser } from '../e2e/shared-browser.js';
import { nodePackage } from '../web/built-package.js';
import { objText, wavyRing } from '../web/model-text.js';

const model = objText(wavyRing(6));
const options = { parts: 3, seed: 2, height: 80 };

/** Formats that need nothing else, fonts, and the renderer of pictures. */
const formats = ['fold', 'pdf', 'png'] as const;

/** The bytes of files by their formats. */
type Written = Record<string, readonly number[]>;

/** Written as a stranger would, from `docs/package.md`. */
export const script = `
import { unfold } from 'foldwright';
import 'foldwright/studio';
import 'foldwright/viewer';

const text = await (await fetch('ring.obj')).text();
const bytes = new TextEncoder().encode(text);
const unfolded = await unfold([{ name: 'ring.obj', bytes }], ${JSON.stringify(options)});
const written = {};
for (const format of ${JSON.stringify(formats)}) {
  const [file] = await unfolded.export(format);
  written[format] = [...file.bytes];
}
globalThis.written = written;
`;

/** The page around it; its script is called \`main.js\` unless a bundler says otherwise. */
export function html(address = 'main.js'): string {
  return `<!doctype html><html lang="en"><title>A shop</title><link rel="icon" href="data:," />
    <script type="module" src="${address}"></script>
    <foldwright-viewer src="ring.obj" parts="3" seed="2" view="both"></foldwright-viewer>
    <foldwright-studio></foldwright-studio></html>`;
}

/** The model that the page loads, in the folder that is served. */
export function writeModel(folder: string): Promise<void> {
  return writeFile(join(folder, 'ring.obj'), model);
}

let underNode: Promise<Written> | null = null;

/** What the package writes under node. */
function writtenUnderNode(): Promise<Written> {
  return (underNode ??= (async () => {
    const { open } = await nodePackage();
    const session = await open([{ name: 'ring.obj', bytes: new TextEncoder().encode(model) }]);
    await session.run(options);
    const written: Written = {};
    for (const format of formats) {
      const [file] = await session.export(format);
      written[format] = [...file!.bytes];
    }
    session.close();
    return written;
  })());
}

/** Opens the page at an address, and looks whether all of the package works in it. */
export async function checkPage(address: string): Promise<void> {
  const context = await (await sharedBrowser()).newContext({ reducedMotion: 'reduce' });
  const page = await context.newPage();
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('response', (response) => {
    if (response.status() >= 400) complaints.push(`${response.status()}: ${response.url()}`);
  });
  try {
    await page.goto(address);
    // Both elements have workers of their own kinds, pictures and sample models.
    const viewer = page.locator('foldwright-viewer');
    await viewer.getByRole('button', { name: 'Unfold' }).click();
    await viewer.locator('.sheet svg').first().waitFor({ timeout: 60_000 });
    await viewer.locator('canvas').waitFor();
    const studio = page.locator('foldwright-studio');
    await studio.locator('.sample', { hasText: 'Cube' }).click();
    await studio.locator('#sheets svg').first().waitFor({ timeout: 60_000 });
    await page.waitForFunction(() => 'written' in globalThis, null, { timeout: 120_000 });
    const written = await page.evaluate(
      () => (globalThis as unknown as { written: Written }).written,
    );
    const expected = await writtenUnderNode();
    for (const format of formats) {
      // Where they differ, a list of all their bytes would help nobody.
      const isSame = Buffer.from(written[format]!).equals(Buffer.from(expected[format]!));
      expect(isSame, `${format} as under node`).toBe(true);
    }
    expect(complaints).toEqual([]);
  } catch (error) {
    console.error(complaints.join('\n'));
    throw error;
  } finally {
    await context.close();
  }
}

/** The same for the page in a folder. */
export async function checkFolder(folder: string): Promise<void> {
  await writeModel(folder);
  const server = await serve(folder);
  try {
    await checkPage(server.address);
  } finally {
    server.close();
  }
}
