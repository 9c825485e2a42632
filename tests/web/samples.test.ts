/** The gallery's models as they are built: their files, their colours, and what the engine makes of them. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { Session } from '../../web/api/session.js';
import { readModelFiles } from '../../web/cli/read-model-files.js';
import { readMtl } from '../../web/read/mtl.js';
import { root } from './packed.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

const folder = join(root, 'web/app/public/samples');

interface Sample {
  id: string;
  file: string;
  files: string[];
  picture: string;
  faces: number;
}

const none = (): Promise<Uint8Array> => Promise.reject(new Error('not needed here'));

/** Faces of the samples, of which projects and pages tell: colours must not change them. */
const faces: Readonly<Record<string, number>> = {
  whale: 420,
  duck: 358,
  cat: 480,
  rabbit: 560,
  fish: 380,
  heart: 238,
  knot: 540,
  star: 60,
  house: 29,
  torus: 112,
  icosahedron: 20,
  cube: 6,
};

/** Those that are made of two halves. */
const halves = ['whale', 'duck', 'cat', 'rabbit', 'fish', 'heart'];

const text = (name: string): string => readFileSync(join(folder, name), 'utf8');
const samples = JSON.parse(text('catalog.json')) as Sample[];

/** Coordinates of the corners of each face of an OBJ file, and the name of its material. */
function facesOf(obj: string): { corners: number[][]; material: string }[] {
  const vertices: number[][] = [];
  const found: { corners: number[][]; material: string }[] = [];
  let material = '';
  for (const [keyword, ...words] of obj.split('\n').map((line) => line.split(' '))) {
    if (keyword === 'v') vertices.push(words.map(Number));
    if (keyword === 'usemtl') material = words[0]!;
    if (keyword !== 'f') continue;
    found.push({ corners: words.map((word) => vertices[Number(word) - 1]!), material });
  }
  return found;
}

/** The corners of a face in an order of their own, mirrored at x = 0 if asked for. */
function keyOf(corners: number[][], side: 1 | -1): string {
  // Adding zero makes a zero of a negative one.
  const points = corners.map(([x, y, z]) => [side * x! + 0, y, z].join(' '));
  return points.sort().join(', ');
}

describe('the samples', () => {
  it('are those whose faces are known', () => {
    expect(samples.map(({ id }) => id)).toEqual(Object.keys(faces));
  });

  it.each(samples)('$id has all of its files, and as many faces as ever', (sample) => {
    expect(sample.files).toEqual([sample.file, `${sample.id}.mtl`]);
    expect(sample.faces).toBe(faces[sample.id]);
    expect(facesOf(text(sample.file))).toHaveLength(sample.faces);
  });

  it.each(samples)('$id has faces of each of its materials, which are two at least', (sample) => {
    const [obj, mtl] = sample.files.map(text) as [string, string];
    expect(obj.split('\n')).toContain(`mtllib ${sample.id}.mtl`);
    const materials = readMtl(new TextEncoder().encode(mtl));
    const used = new Set(facesOf(obj).map(({ material }) => material));
    expect(new Set(materials.map(({ name }) => name))).toEqual(used);
    const colours = new Set(materials.map(({ colour }) => colour?.join()));
    expect(colours.size).toBe(materials.length);
    expect(colours.size).toBeGreaterThan(1);
  });

  it.each(halves)('%s has the same colours on both sides', (id) => {
    const all = facesOf(text(`${id}.obj`));
    const materials = new Map(all.map(({ corners, material }) => [keyOf(corners, 1), material]));
    expect(materials.size).toBe(all.length);
    const other = all.filter(
      ({ corners, material }) => materials.get(keyOf(corners, -1)) !== material,
    );
    expect(other).toEqual([]);
  });

  it.each(samples)('$id is drawn in more colours than a white model had shades', ({ picture }) => {
    const fills = text(picture).match(/fill="#[0-9a-f]{6}"/g);
    expect(new Set(fills).size).toBeGreaterThan(2);
  });
});

describe.runIf(isEngineBuilt)('a result of a sample', () => {
  it('has its colours, and nothing to be told of them', () =>
    withThreads(1, async (pool) => {
      const files = readModelFiles(join(folder, 'cube.obj'));
      const session = new Session(files, { pool: () => pool, loadFont: none, loadRenderer: none });
      await session.run({ runs: 4, seed: 1 });
      const { looks, notices } = await session.result();
      expect(looks?.materials.map(({ name }) => name)).toEqual([
        'back',
        'front',
        'bottom',
        'top',
        'left',
        'right',
      ]);
      expect(looks?.materials[3]?.colour).toEqual([255, 210, 63]);
      expect(new Set(looks?.surface.materials)).toEqual(new Set([0, 1, 2, 3, 4, 5]));
      expect(notices).toEqual([]);
    }));
});
