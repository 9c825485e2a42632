/** Models from addresses, with the files that they name. */
import { afterEach, describe, expect, it, vi } from 'vitest';
import { fetchModelFile } from '../../web/app/model-file.js';
import { png } from './tiny-pictures.js';
import { faultOf } from './unusable.js';

const page = 'https://paper.example/shop/index.html';
const shop = 'https://paper.example/shop/models/';

/** Answers with these files, by their addresses below the shop's models; others are not there. @returns what was asked for */
function serve(files: Readonly<Record<string, string | Uint8Array>>): string[] {
  const asked: string[] = [];
  vi.stubGlobal('fetch', (address: URL) => {
    asked.push(address.href);
    const content = files[address.href.slice(shop.length)];
    if (content === undefined) return Promise.resolve(new Response(null, { status: 404 }));
    return Promise.resolve(new Response(content as BodyInit));
  });
  return asked;
}

const fetched = async (address: string): Promise<string[]> => {
  const { files } = await fetchModelFile(address, page, new AbortController().signal);
  return files.map(({ name }) => name);
};

afterEach(() => vi.unstubAllGlobals());

describe('a model from an address', () => {
  it('comes with the materials that it names, and with their pictures', async () => {
    const asked = serve({
      'cat.obj?size=2': 'mtllib looks/cat.mtl\nv 0 0 0\nusemtl fur\n',
      'looks/cat.mtl':
        'newmtl fur\nKd 1 1 1\nmap_Kd my fur.png\nnewmtl eye\nmap_Kd gone%20eye.png\n',
      'looks/my%20fur.png': png,
    });
    expect(await fetched('models/cat.obj?size=2')).toEqual([
      'cat.obj',
      'looks/cat.mtl',
      'looks/my fur.png',
    ]);
    expect(asked.map((address) => address.slice(shop.length))).toEqual([
      'cat.obj?size=2',
      'looks/cat.mtl',
      'looks/my%20fur.png',
      'looks/gone%20eye.png',
    ]);
  });

  it('comes without those that are not there, each of which is asked for once', async () => {
    const asked = serve({ 'cat.obj': 'mtllib cat.mtl\nmtllib cat.mtl\nv 0 0 0\n' });
    expect(await fetched('models/cat.obj')).toEqual(['cat.obj']);
    expect(asked).toEqual([`${shop}cat.obj`, `${shop}cat.mtl`]);
  });

  it('asks for nothing outside of its folder', async () => {
    const names = ['../cat.mtl', '/cat.mtl', 'https://other.example/cat.mtl', 'C:\\cat.mtl'];
    const asked = serve({ 'cat.obj': names.map((name) => `mtllib ${name}\n`).join('') });
    await fetched('models/cat.obj');
    // The name alone is looked for beside the model.
    expect(asked).toEqual([`${shop}cat.obj`, `${shop}cat.mtl`]);
  });

  it('is given up with what it names', async () => {
    const controller = new AbortController();
    vi.stubGlobal('location', new URL(page));
    vi.stubGlobal('fetch', (address: URL) => {
      if (address.href.endsWith('.obj')) return Promise.resolve(new Response('mtllib cat.mtl\n'));
      controller.abort();
      return Promise.reject(controller.signal.reason as Error);
    });
    const choice = fetchModelFile('models/cat.obj', page, controller.signal);
    expect(await faultOf(choice)).toContain('“cat.obj” cannot be loaded.');
  });
});
