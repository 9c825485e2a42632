/** Printed colours, taken back onto their models and compared with what another program sees there. */
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { makeDoor } from '../../web/api/door.js';
import type { Options } from '../../web/api/written-options.js';
import type { ModelFile } from '../../web/model/model-files.js';
import { Scene } from '../web/gltf-files.js';
import { pngOf } from '../web/looked-cube.js';
import { readRenderer } from '../web/printed.js';
import { checkTexture, type TextureFigures } from '../web/texture-check.js';
import { withThreads } from '../web/thread-pool.js';
import type { TrueSurface } from '../web/true-surface.js';
import { sharedBrowser } from './shared-browser.js';
import { TrueSurfaces } from './true-surfaces.js';

// Nothing turns the models: the other program does not do so either.
const usual: Options = { up: 'y', runs: 4, folding: 'off', compact: 'off', dpi: 150 };

async function printed(
  files: ModelFile[],
  options: Options = {},
  change: (surface: TrueSurface) => void = () => undefined,
): Promise<TextureFigures> {
  const surfaces = await TrueSurfaces.start(await sharedBrowser());
  const surface = await surfaces.of(files);
  change(surface);
  return withThreads(1, async (pool) => {
    const loadFont = (): Promise<never> => Promise.reject(new Error('not needed here'));
    const door = makeDoor({ startPool: () => pool, loadFont, loadRenderer: readRenderer });
    const session = await door.open(files, { pool });
    await session.run({ ...usual, ...options });
    const sheets = await session.export('svg');
    const texts = sheets.map(({ bytes }) => new TextDecoder().decode(bytes));
    return checkTexture(await session.result(), texts, surface);
  });
}

/** A coloured sample of the studio's. */
function sample(name: string): Promise<ModelFile[]> {
  const files = ['obj', 'mtl'].map(async (ending): Promise<ModelFile> => {
    const address = new URL(`../../dist/studio/samples/${name}.${ending}`, import.meta.url);
    return {
      name: `${name}.${ending}`,
      bytes: new Uint8Array(await readFile(fileURLToPath(address))),
    };
  });
  return Promise.all(files);
}

/** A picture that no turn and no mirror leaves as it is, with soft borders as photographs have them. */
const picture = pngOf(64, 64, (x, y) => [4 * x, 4 * y, x > y ? 255 : 40]);

/** A tetrahedron in a picture, or in colours of its corners. */
async function tetrahedron(has: 'picture' | 'colours'): Promise<ModelFile[]> {
  const [a, b, c, d] = [
    [0, 0, 0],
    [1, 0, 0.2],
    [0.3, 0, -0.9],
    [0.4, 0.8, -0.3],
  ] as const;
  const corners = [a, c, b, a, b, d, b, c, d, c, a, d];
  const scene = new Scene();
  const node = scene.add({ positions: corners.flat(), corners: corners.map((_, i) => i) });
  const material = scene.document.createMaterial();
  const primitive = node.getMesh()!.listPrimitives()[0]!.setMaterial(material);
  if (has === 'picture') {
    const texture = scene.document.createTexture().setImage(picture).setMimeType('image/png');
    material.setBaseColorTexture(texture);
    const places = corners.flatMap(
      (_, i) =>
        [
          [0.1, 0.2],
          [0.9, 0.3],
          [0.4, 0.9],
        ][i % 3]!,
    );
    primitive.setAttribute('TEXCOORD_0', scene.list('VEC2', new Float32Array(places)));
  } else {
    const colours = corners.flatMap(([x, y, z]) => [x, 1 - y, (0.3 - z) / 1.2]);
    primitive.setAttribute('COLOR_0', scene.list('VEC3', new Float32Array(colours)));
  }
  return [{ name: 'tetrahedron.glb', bytes: await scene.glb() }];
}

function expectRight({ mean, off, bare, bareBleed, bareFlaps }: TextureFigures): void {
  expect([bare, bareBleed, bareFlaps]).toEqual([0, 0, 0]);
  expect(mean).toBeLessThan(1);
  expect(off).toBeLessThan(0.5);
}

test.each(['house', 'heart'])('the sample %s is printed in its colours', async (name) => {
  const figures = await printed(await sample(name));
  expectRight(figures);
  expect(figures.distance).toBeLessThan(0.001);
  expect(figures.dots).toBeGreaterThan(1000);
});

test('pictures are printed in their place, and colours of corners as light mixes', async () => {
  expectRight(await printed(await tetrahedron('picture')));
  expectRight(await printed(await tetrahedron('colours')));
});

test('what is mirrored or upside down would be found', async () => {
  for (const axis of [0, 1]) {
    const { mean, off } = await printed(await tetrahedron('picture'), {}, ({ places }) => {
      for (let at = axis; at < places.length; at += 2) places[at] = 1 - places[at]!;
    });
    expect(mean).toBeGreaterThan(30);
    expect(off).toBeGreaterThan(60);
  }
});

test('a simplified sample has the colours of the surface before', async () => {
  const figures = await printed(await sample('torus'), { faces: 100 });
  expect([figures.bare, figures.bareBleed, figures.bareFlaps]).toEqual([0, 0, 0]);
  // Borders of colours move with the faces by as much as these are from the surface.
  expect(figures.off).toBeLessThan(3);
});
