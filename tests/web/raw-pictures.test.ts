/** BMP and TGA pictures, against the writer of one library and the reader of another. */
import { TGALoader } from 'three/addons/loaders/TGALoader.js';
import { describe, expect, it } from 'vitest';
import { readBmp } from '../../web/model/bmp.js';
import { pictureHeader } from '../../web/model/picture-header.js';
import { readTga } from '../../web/model/tga.js';
import { bmpFiles, pixelsOf } from './bmp-files.js';
import { tgaOf, type TgaSpec } from './tga-file.js';

const bytesOf = (text: string): Uint8Array => new Uint8Array(Buffer.from(text, 'base64'));

/** Without what says how much a pixel covers. */
function coloursOf(rgba: Uint8Array): number[] {
  return [...rgba].filter((_, i) => i % 4 < 3);
}

describe('readBmp', () => {
  it.each(bmpFiles)('reads %s bits', (name, text) => {
    const bytes = bytesOf(text);
    expect(pictureHeader(bytes)).toEqual({ kind: 'bmp', width: 7, height: 5 });
    const expected = pixelsOf(parseInt(name));
    coloursOf(readBmp(bytes)!.rgba).forEach((value, i) => {
      // Five bits of each colour are left of sixteen.
      expect(Math.abs(value - expected[i]!)).toBeLessThan(name.startsWith('16') ? 8 : 1);
    });
  });

  it.each(bmpFiles)('gives nothing of %s bits that are cut off', (_, text) => {
    const bytes = bytesOf(text);
    for (let length = 0; length < bytes.length - 4; ++length) {
      const found = readBmp(bytes.slice(0, length));
      if (found) expect(found.rgba).toHaveLength(140);
    }
    expect(readBmp(bytes.slice(0, 60))).toBeNull();
  });

  it('reads runs of 4 bits, with stretches without runs and gaps', () => {
    const header = bytesOf(bmpFiles.find(([name]) => name === '4')![1]).slice(0, 86);
    new DataView(header.buffer).setUint32(30, 2, true);
    const below = [4, 0x12, 0, 3, 0x34, 0x50, 0, 0];
    const above = [0, 2, 2, 1, 2, 0x66, 0, 1];
    const { rgba } = readBmp(Uint8Array.from([...header, ...below, ...above]))!;
    const red = (x: number, y: number): number => rgba[4 * (7 * (4 - y) + x)]!;
    const row = (y: number): number[] => [0, 1, 2, 3, 4, 5, 6].map((x) => red(x, y));
    const table = [0xff, 0, 0, 0xff, 0x12, 0xff, 0, 0x80];
    expect(row(0)).toEqual([1, 2, 1, 2, 3, 4, 5].map((number) => table[number]));
    expect(row(1)).toEqual([0, 0, 0, 0, 0, 0, 0].map((number) => table[number]));
    expect(row(2)).toEqual([0, 0, 6, 6, 0, 0, 0].map((number) => table[number]));
  });

  it('asks for no memory that a few runs cannot fill', () => {
    const bytes = bytesOf(bmpFiles.find(([name]) => name === '8 runs')![1]);
    new DataView(bytes.buffer).setInt32(18, 8000, true);
    new DataView(bytes.buffer).setInt32(22, 8000, true);
    expect(readBmp(bytes)).toBeNull();
  });
});

/** Pixels of so many bytes, some of them alike. */
function noise(count: number, size: number): number[][] {
  return Array.from({ length: count }, (_, i) =>
    Array.from({ length: size }, (_unused, k) => ((i >> 2) * 53 + k * 101) % 256),
  );
}

const specs: readonly TgaSpec[] = [
  { kind: 'colours', depth: 24 },
  { kind: 'colours', depth: 24, isFromAbove: true },
  { kind: 'colours', depth: 24, isFromRight: true },
  { kind: 'colours', depth: 24, isPacked: true },
  { kind: 'colours', depth: 32, alphaBits: 8 },
  { kind: 'colours', depth: 32, alphaBits: 8, isPacked: true, isFromAbove: true },
  { kind: 'colours', depth: 16 },
  { kind: 'grey', depth: 8 },
  { kind: 'grey', depth: 8, isPacked: true },
];

const size = [6, 4] as const;

describe('readTga', () => {
  it.each(specs)('reads what another library reads: %o', (spec) => {
    const bytes = tgaOf(spec, size, noise(24, Math.ceil(spec.depth / 8)));
    expect(pictureHeader(bytes)).toEqual({ kind: 'tga', width: 6, height: 4 });
    const { data } = new TGALoader().parse(bytes.slice().buffer);
    const expected = coloursOf(data as Uint8Array);
    coloursOf(readTga(bytes)!.rgba).forEach((value, i) => {
      // The other library leaves the low bits of sixteen at 0.
      expect(Math.abs(value - expected[i]!)).toBeLessThan(spec.depth === 16 ? 8 : 1);
    });
  });

  it('reads colours of a table', () => {
    const pixels = [[0], [1], [2], [2]];
    const table = [1, 2, 3, 10, 20, 30, 7, 8, 9];
    const bytes = tgaOf({ kind: 'table', depth: 8, isFromAbove: true }, [2, 2], pixels, table);
    expect(coloursOf(readTga(bytes)!.rgba)).toEqual([3, 2, 1, 30, 20, 10, 9, 8, 7, 9, 8, 7]);
  });

  it('takes a cover of 0 everywhere for none', () => {
    const pixels = [
      [1, 2, 3, 0],
      [4, 5, 6, 0],
    ];
    const spec = { kind: 'colours', depth: 32, alphaBits: 8 } as const;
    expect([...readTga(tgaOf(spec, [2, 1], pixels))!.rgba]).toEqual([3, 2, 1, 255, 6, 5, 4, 255]);
    pixels[1]![3] = 9;
    expect([...readTga(tgaOf(spec, [2, 1], pixels))!.rgba]).toEqual([3, 2, 1, 0, 6, 5, 4, 9]);
  });

  it.each(specs)('gives nothing of a file that is cut off: %o', (spec) => {
    const bytes = tgaOf(spec, size, noise(24, Math.ceil(spec.depth / 8)));
    expect(readTga(bytes)).not.toBeNull();
    for (let length = 0; length < bytes.length; ++length) {
      expect(readTga(bytes.slice(0, length))).toBeNull();
    }
  });

  it('asks for no memory that a few runs cannot fill', () => {
    const bytes = tgaOf({ kind: 'colours', depth: 24, isPacked: true }, [8000, 8000], noise(24, 3));
    expect(readTga(bytes)).toBeNull();
  });

  it('is not what other files begin with', () => {
    for (const text of ['v 0 0 0\nv 1 0 0\nf 1 2 3\n', '\0'.repeat(40), 'solid cube\nfacet normal'])
      expect(pictureHeader(new TextEncoder().encode(text))).toBeNull();
  });
});
