/** Files that were damaged on their way: a result or a sentence each time, and soon. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Document } from '@gltf-transform/core';
import { EXTMeshoptCompression, KHRDracoMeshCompression } from '@gltf-transform/extensions';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { describe, expect, it } from 'vitest';
import type { ModelFile } from '../../web/model/model-files.js';
import { checkPicture, decodePicture } from '../../web/export/texture/decode-picture.js';
import { startRenderer } from '../../web/export/renderer.js';
import { startWebp } from '../../web/export/texture/webp.js';
import { bmpFiles } from './bmp-files.js';
import { sharedFolder } from './command.js';
import { readRenderer } from './printed.js';
import { tgaOf } from './tga-file.js';
import { webp } from './webp-file.js';
import { Scene } from './gltf-files.js';
import { damaged, numbers } from './damage.js';
import { wavyRing } from './model-text.js';
import { pdoFile } from './pdo-files.js';
import { refusal, type Triangles } from './read-model.js';
import { box, objOf } from './solids.js';
import { meshObject, modelPart, threeMf, zip } from './zips.js';

const seed = 20261129;

const shared = sharedFolder();

const noise = Array.from({ length: 16 }, (_, i) => [i, 2 * i, 99, 255 - i]);

/** Far above what a damaged file of a few kilobytes takes here, and what people wait for. In ms. */
const patience = 10_000;

function ring(): Triangles {
  const { vertices, faces } = wavyRing(12);
  return { positions: vertices.flat(), corners: faces.flat() };
}

/** A GLB file of the ring, compressed by what `compress` adds to it. */
async function glb(compress: (document: Document) => void = () => undefined): Promise<ModelFile> {
  await MeshoptEncoder.ready;
  const scene = new Scene();
  scene.add(ring());
  compress(scene.document);
  return { name: 'a.glb', bytes: await scene.glb() };
}

const draco = (document: Document): void => {
  document.createExtension(KHRDracoMeshCompression).setRequired(true);
};

const meshopt = (document: Document): void => {
  document.createExtension(EXTMeshoptCompression).setRequired(true);
};

const pictured = {
  name: 'pictured',
  colour: [1, 1, 1],
  picture: { width: 8, height: 8, rgb: new Uint8Array(192).fill(7) },
};

function fold(): ModelFile {
  const { vertices, faces } = wavyRing(12);
  const content = { file_spec: 1.2, vertices_coords: vertices, faces_vertices: faces };
  return { name: 'a.fold', bytes: new TextEncoder().encode(JSON.stringify(content)) };
}

const cases: readonly [string, () => Promise<ModelFile>][] = [
  ['GLB', () => glb()],
  ['Draco', () => glb(draco)],
  ['meshopt', () => glb(meshopt)],
  ['3MF', () => Promise.resolve(threeMf(modelPart(meshObject(1, ring()), '<item objectid="1"/>')))],
  ['PDO', () => Promise.resolve(pdoFile({ materials: [pictured] }))],
  ['FOLD', () => Promise.resolve(fold())],
  ['ZIP', () => Promise.resolve(zip('a.zip', { 'a.obj': objOf(box(1, 2, 3)) }))],
];

/** Sentence by sentence, each within the time that people wait. */
async function expectSentence(file: ModelFile, place: string): Promise<void> {
  const begin = performance.now();
  const sentence = await refusal([file]);
  expect(performance.now() - begin, place).toBeLessThan(patience);
  expect(sentence, place).toMatch(/^[^\n]+$/);
  expect(sentence, place).not.toContain("message '");
}

describe('damaged files', () => {
  it.each(cases)('of %s give a result or a sentence', { timeout: 120_000 }, async (_, make) => {
    const file = await make();
    expect(await refusal([file])).toBe('read');
    const below = numbers(seed);
    for (let i = 0; i < 150; ++i) {
      await expectSentence(
        { ...file, bytes: damaged(file.bytes, below) },
        `seed ${seed}, file ${i}`,
      );
    }
  });

  it.skipIf(shared === null)('of another writer of PDO as well', { timeout: 120_000 }, async () => {
    const below = numbers(seed);
    const folder = join(shared!, 'models/pdo');
    const names = readdirSync(folder).filter((name) => name.endsWith('.pdo'));
    for (const name of names) {
      const bytes = new Uint8Array(readFileSync(join(folder, name)));
      for (let i = 0; i < 60; ++i) {
        await expectSentence({ name, bytes: damaged(bytes, below) }, `seed ${seed}, ${name} ${i}`);
      }
    }
  });
});

describe('damaged pictures', () => {
  const pictures: readonly [string, Uint8Array][] = [
    ['BMP', new Uint8Array(Buffer.from(bmpFiles[0]![1], 'base64'))],
    ['BMP with runs', new Uint8Array(Buffer.from(bmpFiles[6]![1], 'base64'))],
    ['TGA', tgaOf({ kind: 'colours', depth: 32, isPacked: true }, [4, 4], noise)],
    ['WebP', webp],
  ];

  it.each(pictures)('of %s give pixels or nothing', async (_, bytes) => {
    await startRenderer(readRenderer);
    await startWebp(readRenderer);
    const below = numbers(seed);
    for (let i = 0; i < 300; ++i) {
      const broken = damaged(bytes, below);
      const header = checkPicture(broken);
      if (typeof header === 'string' || header.width * header.height > 1e6) continue;
      const found = await decodePicture(header, broken);
      if (found) expect(found.rgb).toHaveLength(3 * found.width * found.height);
    }
  });
});

/** Seconds of a long run with other damages each time, which `npm run fuzz` asks for. */
const seconds = Number(process.env['FOLDWRIGHT_FUZZ_SECONDS'] ?? 0);

describe.skipIf(seconds === 0)('a long run', () => {
  it('finds no file without an answer', { timeout: 1000 * seconds + 120_000 }, async () => {
    const files = await Promise.all(cases.map(([, make]) => make()));
    const end = performance.now() + 1000 * seconds;
    let count = 0;
    for (let begin = Date.now() >>> 0; performance.now() < end; ++begin) {
      const below = numbers(begin);
      const file = files[below(files.length)]!;
      let { bytes } = file;
      for (let left = below(3); left >= 0; --left) bytes = damaged(bytes, below);
      await expectSentence({ ...file, bytes }, `seed ${begin}, ${file.name}`);
      ++count;
    }
    console.log(`${count} damaged files in ${seconds} s`);
  });
});
