import UPNG from '@pdf-lib/upng';
import { describe, expect, it } from 'vitest';
import { pngFile } from '../../web/export/texture/png-file.js';

describe('pngFile', () => {
  it.each([
    [1, 1, 4],
    [5, 3, 3],
    [64, 48, 4],
    [33, 70, 3],
  ] as const)(
    'holds every value as another library reads it: %i x %i x %i',
    (width, height, channels) => {
      // Slopes, noise and even stretches, so that every filter is chosen somewhere.
      const values = Uint8Array.from({ length: width * height * channels }, (_, i) => {
        const [dot, channel] = [Math.floor(i / channels), i % channels];
        if (channel === 3) return dot % 7 === 0 ? 0 : 255;
        const [x, y] = [dot % width, Math.floor(dot / width)];
        return [x * 5 + y * channel, y * 9, (x * x * 31 + y * y * 17) % 251, 200][(y >> 3) & 3]!;
      });
      const image = UPNG.decode(pngFile({ width, height, channels, values }).slice().buffer);
      expect([image.width, image.height]).toEqual([width, height]);
      const rgba = new Uint8Array(UPNG.toRGBA8(image)[0]!);
      const read = rgba.filter((_, i) => channels === 4 || i % 4 !== 3);
      expect(Buffer.compare(read, values)).toBe(0);
    },
  );
});
