/** Surfaces as three.js reads them, in a page of their own. */
import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import type { Browser, Page } from 'playwright-core';
import type { ModelFiles } from '../../web/model/model-files.js';
import type { TrueSurface } from '../web/true-surface.js';
import type { SentSurface } from './page-surface.js';

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const decoders = here('../../node_modules/three/examples/jsm/libs/draco/gltf/');
/** Of no server: all requests are answered here. */
const address = 'http://surfaces.test/';

async function pageScript(): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [here('page-surface.ts')],
    bundle: true,
    format: 'esm',
    target: 'es2022',
    write: false,
  });
  return outputFiles[0]!.text;
}

function received(sent: SentSurface): TrueSurface {
  const { corners, places, colours, materials, looks, pictures } = sent;
  return {
    corners: Float64Array.from(corners),
    places: Float64Array.from(places, (place: number | null) => place ?? NaN),
    colours: Float64Array.from(colours),
    materials: Int32Array.from(materials),
    looks,
    pictures: pictures.map(({ width, height, data }) => ({
      width,
      height,
      rgba: new Uint8Array(Buffer.from(data, 'base64')),
    })),
  };
}

export class TrueSurfaces {
  private constructor(private readonly page: Page) {}

  static async start(browser: Browser): Promise<TrueSurfaces> {
    const page = await browser.newPage();
    const script = await pageScript();
    await page.route('**/*', async (route) => {
      const path = new URL(route.request().url()).pathname;
      if (path.startsWith('/draco/')) {
        await route.fulfill({ body: await readFile(decoders + basename(path)) });
      } else if (path === '/surface.js') {
        await route.fulfill({ contentType: 'text/javascript', body: script });
      } else if (path === '/') await route.fulfill({ contentType: 'text/html', body: '<body>' });
      else await route.fulfill({ status: 404 });
    });
    await page.goto(address);
    await page.addScriptTag({ url: '/surface.js', type: 'module' });
    return new TrueSurfaces(page);
  }

  /** @param files of a model, whose own file comes first */
  async of(files: ModelFiles): Promise<TrueSurface> {
    const sent = files.map(({ name, bytes }) => ({
      name,
      data: Buffer.from(bytes).toString('base64'),
    }));
    return received(await this.page.evaluate((all) => window.pageSurface(all), sent));
  }
}
