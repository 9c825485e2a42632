import { mkdir, mkdtemp, readdir, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { serve } from '../../scripts/serve.mjs';
import { watchPage } from './page-watch.js';

const built = fileURLToPath(new URL('../../dist/studio', import.meta.url));

export interface WatchedSite {
  address: string;
  close(): Promise<void>;
}

/** Serves the built studio with a page that is watched by `watchPage`; all other files are those of the build. */
export async function serveWatched(): Promise<WatchedSite> {
  const folder = await mkdtemp(join(tmpdir(), 'foldwright-watched-'));
  const studio = join(folder, 'studio');
  await mkdir(studio);
  for (const name of await readdir(built)) {
    if (name !== 'index.html') await symlink(join(built, name), join(studio, name));
  }
  await writeFile(join(studio, 'page-watch.js'), `(${String(watchPage)})();`);
  const page = await readFile(join(built, 'index.html'), 'utf8');
  const watched = page.replace('<title>', '<script src="./page-watch.js"></script><title>');
  await writeFile(join(studio, 'index.html'), watched);
  const server = await serve(folder);
  const close = async (): Promise<void> => {
    server.close();
    await rm(folder, { recursive: true });
  };
  return { address: `${server.address}studio/`, close };
}
