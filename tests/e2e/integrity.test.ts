/** Modules that a page checks by the hashes of the build. */
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { serve } from '../../scripts/serve.mjs';
import { sharedBrowser } from './shared-browser.js';

const built = fileURLToPath(new URL('../../dist/studio', import.meta.url));

/** Whether a page gets the viewer whose modules must have these hashes. */
async function getsViewer(hashes: Record<string, string>): Promise<boolean> {
  const folder = await mkdtemp(join(tmpdir(), 'foldwright-integrity-'));
  const host = await serve(built, { headers: { 'access-control-allow-origin': '*' } });
  const integrity = Object.fromEntries(
    Object.entries(hashes).map(([name, hash]) => [new URL(name, host.address).href, hash]),
  );
  const html = `<!doctype html><title>A shop</title>
    <script type="importmap">${JSON.stringify({ integrity })}</script>
    <script type="module" src="${host.address}foldwright-viewer.js"></script>`;
  await writeFile(join(folder, 'index.html'), html);
  const server = await serve(folder);
  const page = await (await sharedBrowser()).newPage();
  try {
    await page.goto(server.address, { waitUntil: 'load' });
    return await page.evaluate(() => customElements.get('foldwright-viewer') !== undefined);
  } finally {
    await page.close();
    server.close();
    host.close();
    await rm(folder, { recursive: true, force: true });
  }
}

test('a page takes the modules whose hashes are right, and no others', async () => {
  const { integrity } = JSON.parse(await readFile(join(built, 'integrity.json'), 'utf8')) as {
    integrity: Record<string, string>;
  };
  expect(await getsViewer(integrity)).toBe(true);
  const wrong = Object.fromEntries(
    Object.keys(integrity).map((name) => [name, integrity['./index.html']!]),
  );
  expect(await getsViewer(wrong)).toBe(false);
});
