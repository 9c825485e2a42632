import { mkdtemp, readdir, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { serve } from '../../scripts/serve.mjs';
import { watchPage } from '../browsers/page-watch.js';

const built = fileURLToPath(new URL('../../dist/studio', import.meta.url));
const guide = fileURLToPath(new URL('../../docs/elements.md', import.meta.url));

/** A page that allows no more than it says it needs: models of its own, and what the guide names for a host. */
async function documentedPolicy(host: string): Promise<string> {
  const rows = (await readFile(guide, 'utf8')).matchAll(/^\| `([a-z]+-src)` \| (.*?) \|/gm);
  const directives = [...rows].map(([, name, value]) => {
    const sources = [...value!.matchAll(/`([^`]+)`/g)].map(([, source]) => source!);
    const own = name === 'connect-src' ? ["'self'"] : [];
    return [name, ...sources, ...own].join(' ').replaceAll('HOST', host);
  });
  return ["default-src 'none'", ...directives].join('; ');
}

/** Two viewers and a studio, without a style or a script of the page's own. */
const pageOf = (host: string): string => `<!doctype html><html lang="en"><title>A shop</title>
  <link rel="icon" href="data:," /><script src="${host}page-watch.js"></script>
  <script type="module" src="${host}foldwright-viewer.js"></script>
  <script type="module" src="${host}foldwright-studio.js"></script>
  <foldwright-viewer src="model.fold" alt="A ring" controls></foldwright-viewer>
  <foldwright-viewer src="model.obj" parts="3" seed="2" view="nets"></foldwright-viewer>
  <foldwright-studio></foldwright-studio></html>`;

export interface EmbeddingSite {
  address: string;
  /** The policy that its page is sent with. */
  policy: string;
  close(): Promise<void>;
}

/**
 * Serves a plain page with both elements, whose files come from another port, under the policy that the guide
 * documents. The page is watched by `watchPage`.
 *
 * @param files of the page: `model.fold` and `model.obj`
 */
export async function serveEmbedding(files: Record<string, string>): Promise<EmbeddingSite> {
  const [vendor, shop] = await Promise.all(
    ['vendor', 'shop'].map((name) => mkdtemp(join(tmpdir(), `foldwright-${name}-`))),
  );
  for (const name of await readdir(built)) await symlink(join(built, name), join(vendor!, name));
  await writeFile(join(vendor!, 'page-watch.js'), `(${String(watchPage)})();`);
  const host = await serve(vendor!, { headers: { 'access-control-allow-origin': '*' } });
  const policy = await documentedPolicy(new URL(host.address).origin);
  for (const [name, text] of Object.entries({ 'index.html': pageOf(host.address), ...files })) {
    await writeFile(join(shop!, name), text);
  }
  const { address, close } = await serve(shop!, { headers: { 'content-security-policy': policy } });
  return {
    address,
    policy,
    async close() {
      close();
      host.close();
      for (const folder of [vendor!, shop!]) await rm(folder, { recursive: true });
    },
  };
}
