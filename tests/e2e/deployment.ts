import { cp, mkdtemp, readdir, readFile, rename, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { serve } from '../../scripts/serve.mjs';

const built = fileURLToPath(new URL('../../dist/studio', import.meta.url));

/** Text files of the studio in which names of others stand. */
const text = /\.(?:css|html|js)$/;
const hashed = /-[\w-]{8}(?=\.\w+$)/;

/** The built studio on a server that can go away, in a folder where another build can take its place. */
export class Deployment {
  private constructor(
    private readonly folder: string,
    private readonly server: Awaited<ReturnType<typeof serve>>,
  ) {}

  static async start(): Promise<Deployment> {
    const folder = await mkdtemp(join(tmpdir(), 'foldwright-deployment-'));
    await cp(built, join(folder, 'studio'), { recursive: true });
    return new Deployment(folder, await serve(folder));
  }

  /** Of the page. */
  get address(): string {
    return `${this.server.address}studio/`;
  }

  /** From now on nobody answers. */
  stop(): void {
    this.server.close();
  }

  async remove(): Promise<void> {
    this.stop();
    await rm(this.folder, { recursive: true });
  }

  /** A file of the studio is not there. */
  async lose(name: string): Promise<void> {
    await rm(join(this.folder, 'studio', name));
  }

  /** All files are there again. */
  async mend(): Promise<void> {
    await cp(built, join(this.folder, 'studio'), { recursive: true });
  }

  /** Puts a build in the place of this one that has no file with a hash in common with it. */
  async replace(description: string): Promise<void> {
    const studio = join(this.folder, 'studio');
    const all = await readdir(studio, { recursive: true });
    const names = all.filter((name) => hashed.test(name) && !/icon|samples/.test(name));
    // Other hashes: two chunks may differ in nothing else.
    const next = (name: string): string => name.replace(hashed, '$&-next');
    const renamed = new Map(names.map((name) => [name, next(name)]));
    const bases = names.map((name) => name.replace(/.*\//, ''));
    for (const name of all.filter((file) => text.test(file))) {
      let content = await readFile(join(studio, name), 'utf8');
      for (const base of bases) {
        content = content.replaceAll(base, next(base));
      }
      content = content.replace(/(name="description"\s+content=")[^"]*/, `$1${description}`);
      content = content.replace(/"hash":"\w+"/, '"hash":"next"');
      await writeFile(join(studio, name), content);
    }
    for (const [before, after] of renamed) await rename(join(studio, before), join(studio, after));
  }
}
