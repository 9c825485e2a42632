import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import UPNG from '@pdf-lib/upng';
import { describe, expect, it } from 'vitest';
import { cube, pdoFile, type PdoPictureSpec } from './pdo-files.js';
import { sharedFolder } from './command.js';
import { codesOf, read, refusal, sizeOf, trianglesOf, volumeOf } from './read-model.js';

const picture: PdoPictureSpec = {
  width: 2,
  height: 2,
  rgb: Uint8Array.of(255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 9, 9),
};

function pixelsOf(bytes: Uint8Array): PdoPictureSpec {
  const png = UPNG.decode(bytes.slice().buffer);
  const rgb = new Uint8Array(UPNG.toRGBA8(png)[0]!).filter((_, i) => i % 4 < 3);
  return { width: png.width, height: png.height, rgb };
}

const hidden = { ...cube, isVisible: false };

describe('readPdo', () => {
  it.each([
    ['version 4', { version: 4 }],
    ['version 5, shifted texts', { version: 5, shift: 224 }],
    ['version 6, wide texts', { version: 6, shift: 77 }],
  ] as const)('reads polygons and colours of %s', async (_, spec) => {
    const model = await read(pdoFile(spec));
    const { sides, materials, ...found } = trianglesOf(model.file);
    expect(sides).toEqual([4, 4, 4, 4, 4, 4]);
    expect(materials).toEqual([0, 0, 0, 0, 0, 0]);
    expect(volumeOf(found)).toBe(1000);
    expect(sizeOf(found)).toEqual([10, 10, 10]);
    expect(model.usual).toEqual({ up: 'y', unit: 'mm' });
    expect(model.looks!.materials).toMatchObject([{ name: 'paper', colour: [255, 128, 0] }]);
    expect(codesOf(model)).toEqual(['pdo-unused']);
  });

  it('reads pictures and places in them, counted from below', async () => {
    const materials = ['one', 'the same'].map((name) => ({ name, colour: [0, 0, 0], picture }));
    const model = await read(
      pdoFile({ materials, bodies: [{ ...cube, materials: [0, 1, 0, 1, 0, 1] }] }),
    );
    const { cornerPlaces } = trianglesOf(model.file);
    expect(cornerPlaces.slice(0, 8)).toEqual([0, 1, 1, 1, 0, 0, 1, 0]);
    const looks = model.looks!;
    expect(looks.materials.map((material) => [material.picture, ...material.colour])).toEqual([
      [0, 255, 255, 255],
      [0, 255, 255, 255],
    ]);
    expect(looks.pictures).toHaveLength(1);
    const { width, height, rgb } = pixelsOf(looks.pictures[0]!.bytes);
    expect([width, height, ...rgb]).toEqual([2, 2, ...picture.rgb]);
  });

  it('leaves faces plain whose material is not in the file', async () => {
    const model = await read(pdoFile({ bodies: [{ ...cube, materials: [0, -1, 1, -7, 0, 99] }] }));
    expect(trianglesOf(model.file).materials).toEqual([0, -1, -1, -1, 0, -1]);
  });

  it('leaves out pictures that are damaged or far too large', async () => {
    const make = (width: number): Uint8Array =>
      pdoFile({ materials: [{ name: 'm', colour: [1, 1, 1], picture: { ...picture, width } }] })
        .bytes;
    expect(codesOf(await read({ name: 'a.pdo', bytes: make(3) }))).toContain('unread-pictures');
    expect(codesOf(await read({ name: 'a.pdo', bytes: make(70_000) }))).toContain('large-pictures');
  });

  it('hands over the nets with their scale and flaps', async () => {
    const { nets } = await read(pdoFile({ bodies: [{ ...cube, flap: 6 }] }));
    expect(nets!.scale).toBe(2);
    expect(nets!.pieces).toEqual([[90, 70]]);
    // Both sides of five edges.
    expect(nets!.joined.reduce((sum, one) => sum + one)).toBe(10);
    // One side of each of the other seven.
    expect([...nets!.flaps].filter((height) => height === 6)).toHaveLength(7);
  });

  it('has no nets where nothing is unfolded', async () => {
    expect((await read(pdoFile({ pattern: null }))).nets).toBeUndefined();
    expect((await read(pdoFile({ bodies: [{ ...cube, joined: [] }] }))).nets).toBeUndefined();
  });

  it('puts visible bodies together, and counts what it leaves out', async () => {
    const broken = { ...cube, faces: [...cube.faces, [0, 1], [0, 1, 8], [0, -1, 2]] };
    const model = await read(pdoFile({ bodies: [cube, broken, hidden] }));
    expect(volumeOf(trianglesOf(model.file))).toBe(2000);
    expect(model.notices).toContainEqual({
      code: 'pdo-unused',
      params: { hidden: 1, texts: 1, images: 0 },
    });
    expect(model.notices).toContainEqual({ code: 'broken-faces', params: { count: 3 } });
  });

  it('refuses by name what is locked, old, hidden or empty', async () => {
    expect(await refusal([pdoFile({ lock: 1 })])).toBe(
      "'cube.pdo' is locked by the person who made it; ask that person for a file without a lock",
    );
    expect(await refusal([pdoFile({ version: 7 as 6 })])).toContain('not known here (7)');
    const text = new TextEncoder().encode('# Pepakura Designer Work Info ver 2\n#\n');
    expect(await refusal([{ name: 'a.pdo', bytes: text }])).toContain(
      'is of the first Pepakura Designer',
    );
    expect(await refusal([pdoFile({ bodies: [hidden] })])).toContain('all bodies are switched off');
    expect(await refusal([pdoFile({ bodies: [] })])).toContain('without a face');
  });

  it('reads the shape of a file that is cut off behind it, and refuses one cut off before', async () => {
    const { bytes, name } = pdoFile();
    const model = await read({ name, bytes: bytes.slice(0, -1) });
    expect(codesOf(model)).toEqual(['damaged-extras']);
    expect(model.nets).toBeUndefined();
    expect(await refusal([{ name, bytes: bytes.slice(0, 1000) }])).toMatch(
      /^'cube.pdo' is damaged or cut off \(byte \d+\)/,
    );
  });
});

const shared = sharedFolder();

describe.skipIf(shared === null)('files of another writer', () => {
  const names = [
    'synthetic_v4',
    'synthetic_v5_shift200_cp932_ownpage',
    'synthetic_v6_flag1',
    'synthetic_v6_flag3_designer6_tail',
  ];

  it.each(names)('%s gives a house with looks and a net', async (name) => {
    const bytes = new Uint8Array(readFileSync(join(shared!, 'models/pdo', `${name}.pdo`)));
    const { looks, nets, notices } = await read({ name: 'house.pdo', bytes });
    expect(notices).toEqual([{ code: 'pdo-unused', params: { hidden: 0, texts: 1, images: 1 } }]);
    expect(looks!.materials.map(({ picture }) => picture).sort()).toEqual([0, null]);
    const { width, height, rgb } = pixelsOf(looks!.pictures[0]!.bytes);
    expect([width, height, ...rgb.subarray(0, 3)]).toEqual([8, 4, 255, 0, 0]);
    expect(nets!.scale).toBe(2);
    expect(nets!.pieces).toHaveLength(1);
    expect(nets!.joined.reduce((sum, one) => sum + one)).toBe(12);
  });
});
