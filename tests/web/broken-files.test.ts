/** Files that were damaged on their way: a result or a sentence each time, and soon. */
import type { Document } from '@gltf-transform/core';
import { EXTMeshoptCompression, KHRDracoMeshCompression } from '@gltf-transform/extensions';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { describe, expect, it } from 'vitest';
import type { ModelFile } from '../../web/model/model-files.js';
import { Scene } from './gltf-files.js';
import { wavyRing } from './model-text.js';
import { pdoFile } from './pdo-files.js';
import { refusal, type Triangles } from './read-model.js';
import { box, objOf } from './solids.js';
import { meshObject, modelPart, threeMf, zip } from './zips.js';

const seed = 20261129;

/** Far above what a damaged file of a few kilobytes takes here, and what people wait for. In ms. */
const patience = 10_000;

/** A generator of whole numbers below a bound (Numerical Recipes' constants). */
function numbers(begin: number): (below: number) => number {
  let state = begin >>> 0;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

/** Cuts a file off, or flips some of its bits. */
function damaged(bytes: Uint8Array, below: (bound: number) => number): Uint8Array {
  if (below(4) === 0) return bytes.slice(0, below(bytes.length));
  const broken = bytes.slice();
  for (let left = 1 + below(8); left > 0; --left) {
    const at = below(bytes.length);
    broken[at]! ^= 1 << below(8);
  }
  return broken;
}

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

const cases: readonly [string, () => Promise<ModelFile>][] = [
  ['GLB', () => glb()],
  ['Draco', () => glb(draco)],
  ['meshopt', () => glb(meshopt)],
  ['3MF', () => Promise.resolve(threeMf(modelPart(meshObject(1, ring()), '<item objectid="1"/>')))],
  ['PDO', () => Promise.resolve(pdoFile({ materials: [pictured] }))],
  ['ZIP', () => Promise.resolve(zip('a.zip', { 'a.obj': objOf(box(1, 2, 3)) }))],
];

describe('damaged files', () => {
  it.each(cases)('of %s give a result or a sentence', { timeout: 120_000 }, async (_, make) => {
    const file = await make();
    expect(await refusal([file])).toBe('read');
    const below = numbers(seed);
    for (let i = 0; i < 100; ++i) {
      const bytes = damaged(file.bytes, below);
      const begin = performance.now();
      const sentence = await refusal([{ ...file, bytes }]);
      const place = `seed ${seed}, file ${i}`;
      expect(performance.now() - begin, place).toBeLessThan(patience);
      expect(sentence, place).toMatch(/^[^\n]+$/);
      expect(sentence, place).not.toContain("message '");
    }
  });
});
