import { beforeAll, describe, expect, it } from 'vitest';
import { startRenderer } from '../../web/export/renderer.js';
import { checkPicture, decodePicture } from '../../web/export/texture/decode-picture.js';
import { startWebp } from '../../web/export/texture/webp.js';
import { loadPictures } from '../../web/export/texture/load-pictures.js';
import { pictureHeader } from '../../web/model/picture-header.js';
import type { Raster } from '../../web/export/texture/raster.js';
import type { Looks } from '../../web/model/looks.js';
import { bmpFiles, pixelsOf } from './bmp-files.js';
import { tgaOf } from './tga-file.js';
import { webp } from './webp-file.js';
import { jpegOf } from './jpeg-file.js';
import { materialOf, pngOf } from './looked-cube.js';
import { readRenderer } from './printed.js';

// Two pixels, blue and red.
const gif = Uint8Array.from(
  Buffer.from('R0lGODlhAgABAIABAP8AAAAA/ywAAAAAAgABAAACAgwKADs=', 'base64'),
);

async function decoded(bytes: Uint8Array): Promise<Raster | null> {
  const header = checkPicture(bytes);
  if (typeof header === 'string') throw new Error(header);
  return decodePicture(header, bytes);
}

/** A face with each of the pictures, all of which are used. */
function looksOf(pictures: readonly Uint8Array[]): Looks {
  return {
    surface: {
      original: null,
      places: new Float32Array(6 * pictures.length),
      colours: null,
      materials: Int32Array.from(pictures.keys()),
    },
    materials: pictures.map((_, i) => materialOf([9, 9, 9], i)),
    pictures: pictures.map((bytes, i) => ({ name: `${i}.png`, bytes })),
  };
}

/** The first bytes of a PNG file of so many pixels. */
function headOf(width: number, height: number): Uint8Array {
  const bytes = pngOf(1, 1, () => [0, 0, 0]);
  new DataView(bytes.buffer).setUint32(16, width);
  new DataView(bytes.buffer).setUint32(20, height);
  return bytes;
}

beforeAll(async () => {
  await startRenderer(readRenderer);
  await startWebp(readRenderer);
});

describe('decodePicture', () => {
  it('gives every pixel of a PNG file as it is', async () => {
    const noise = (x: number, y: number): number[] =>
      [7, 13, 29].map((step) => (x * x * step + y * 31 * step) & 255);
    const { rgb, ...size } = (await decoded(pngOf(37, 23, noise)))!;
    expect(size).toEqual({ width: 37, height: 23 });
    const expected = Array.from({ length: 37 * 23 }, (_, i) => noise(i % 37, Math.floor(i / 37)));
    expect([...rgb]).toEqual(expected.flat());
  });

  it('puts white behind what is transparent', async () => {
    const shares = [0, 128, 255];
    const { rgb } = (await decoded(pngOf(3, 1, (x) => [200, 0, 100, shares[x]!])))!;
    const expected = shares.flatMap((share) =>
      [200, 0, 100].map((value) => 255 + ((value - 255) * share) / 255),
    );
    rgb.forEach((value, i) => expect(Math.abs(value - expected[i]!)).toBeLessThanOrEqual(1));
  });

  it('reads JPEG and GIF files', async () => {
    const { rgb, ...size } = (await decoded(jpegOf([210, 90, 40])))!;
    expect(size).toEqual({ width: 8, height: 8 });
    [210, 90, 40].forEach((value, i) => expect(Math.abs(rgb[i]! - value)).toBeLessThan(4));
    expect(await decoded(gif)).toEqual({
      width: 2,
      height: 1,
      rgb: Uint8Array.of(0, 0, 255, 255, 0, 0),
    });
  });

  it('reads WebP files, every pixel as it is', async () => {
    const { rgb, ...size } = (await decoded(webp))!;
    expect(size).toEqual({ width: 5, height: 3 });
    const rgba = Array.from({ length: 60 }, (_, i) => (i * 37) % 256);
    expect([...rgb]).toEqual(rgba.filter((_, i) => i % 4 < 3));
  });

  it('reads BMP and TGA files, with white behind what is transparent', async () => {
    const { rgb } = (await decoded(new Uint8Array(Buffer.from(bmpFiles[0]![1], 'base64'))))!;
    expect([...rgb]).toEqual(pixelsOf(24));
    const spec = { kind: 'colours', depth: 32, alphaBits: 8 } as const;
    const half = await decoded(tgaOf(spec, [1, 1], [[0, 100, 200, 51]]));
    expect([...half!.rgb]).toEqual([244, 224, 204]);
  });

  it('gives nothing of damaged files', async () => {
    const whole = pngOf(64, 64, (x, y) => [x * y, x, y]);
    expect(await decoded(whole.subarray(0, 60))).toBeNull();
    expect(await decoded(jpegOf([1, 2, 3]).subarray(0, 100))).toBeNull();
    expect(await decoded(gif.subarray(0, 12))).toBeNull();
    expect(await decoded(webp.subarray(0, 60))).toBeNull();
  });
});

describe('pictureHeader', () => {
  it('finds the size of a JPEG file behind other segments', () => {
    const plain = jpegOf([0, 0, 0]);
    const comment = [0xff, 0xfe, 0, 6, 0xff, 0xc0, 1, 2];
    const bytes = Uint8Array.from([
      ...plain.subarray(0, 2),
      ...comment,
      0xff,
      ...plain.subarray(2),
    ]);
    expect(pictureHeader(bytes)).toEqual({ kind: 'jpeg', width: 8, height: 8 });
  });

  it('reads nothing beyond the end', () => {
    for (const bytes of [pngOf(1, 1, () => [0, 0, 0]), jpegOf([0, 0, 0]), gif, webp]) {
      for (let length = 0; length < 10; ++length) {
        expect(pictureHeader(bytes.slice(0, length))).toBeNull();
      }
    }
  });
});

describe('checkPicture', () => {
  it('refuses what is no picture, or has no or too many pixels', () => {
    expect(checkPicture(new TextEncoder().encode('BM and more'))).toBe('format');
    expect(checkPicture(new Uint8Array())).toBe('format');
    expect(checkPicture(headOf(0, 5))).toBe('damaged');
    expect(checkPicture(headOf(16_385, 1))).toBe('large');
    expect(checkPicture(headOf(8193, 8192))).toBe('large');
    expect(checkPicture(headOf(8192, 8192))).toMatchObject({ width: 8192 });
  });
});

describe('loadPictures', () => {
  const red = pngOf(1, 1, () => [255, 0, 0]);

  it('tells which pictures it cannot read, and why', async () => {
    const broken = red.slice(0, 45);
    const files = [red, new Uint8Array(9), broken, headOf(20_000, 1), new Uint8Array(3)];
    const { pictures, notices } = await loadPictures(looksOf(files), readRenderer);
    expect(pictures.map((picture) => picture !== null)).toEqual([true, false, false, false, false]);
    expect(notices).toEqual([
      { code: 'pictures-unreadable', params: { what: 'format', files: ['1.png', '4.png'] } },
      { code: 'pictures-unreadable', params: { what: 'damaged', files: ['2.png'] } },
      { code: 'pictures-unreadable', params: { what: 'large', files: ['3.png'] } },
    ]);
  });

  it('decodes the same pictures once', async () => {
    const load = (colour: number) =>
      loadPictures(looksOf([pngOf(2, 2, () => [colour, 0, 0])]), readRenderer);
    const first = await load(1);
    expect(await load(1)).toBe(first);
    expect((await load(2)).pictures[0]!.rgb[0]).toBe(2);
    expect((await load(1)).pictures).toEqual(first.pictures);
  });

  it('leaves alone what no face shows', async () => {
    const looks = looksOf([red, new Uint8Array(9)]);
    looks.surface.materials = Int32Array.of(0, -1);
    const { pictures, notices } = await loadPictures(looks, readRenderer);
    expect(pictures).toEqual([{ width: 1, height: 1, rgb: Uint8Array.of(255, 0, 0) }, null]);
    expect(notices).toEqual([]);
  });
});
