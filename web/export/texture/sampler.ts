import type { Wrap } from '../../model/looks.js';
import { halved, type Raster } from './raster.js';

/** The index of a pixel that stands for one beyond the edges; whole numbers. */
export function wrapped(index: number, size: number, wrap: Wrap): number {
  if (index >= 0 && index < size) return index;
  if (wrap === 'clamp') return index < 0 ? 0 : size - 1;
  if (wrap === 'repeat') return ((index % size) + size) % size;
  const turn = ((index % (2 * size)) + 2 * size) % (2 * size);
  return turn < size ? turn : 2 * size - 1 - turn;
}

/**
 * The part of a picture that one dot on paper shows: a parallelogram, in pixels of the picture, of
 * which the mean is taken at so many places along its sides.
 */
export interface Footprint {
  /** How often the picture is halved first. */
  level: number;
  long: readonly [x: number, y: number, steps: number];
  short: readonly [x: number, y: number, steps: number];
}

/** A picture that can be looked up at any size. */
export class Sampler {
  /** Each half the size of the one before. */
  private readonly levels: Raster[];
  private red = 0;
  private green = 0;
  private blue = 0;

  constructor(
    picture: Raster,
    private readonly wrap: readonly [Wrap, Wrap],
  ) {
    this.levels = [picture];
  }

  get width(): number {
    return this.levels[0]!.width;
  }

  get height(): number {
    return this.levels[0]!.height;
  }

  /**
   * Multiplies a colour by that of the picture.
   *
   * @param x from its left, in its pixels, and `y` from above, where the middle of the footprint is
   * @param colour 3 numbers, of which each becomes at most itself
   */
  tint(x: number, y: number, footprint: Footprint, colour: Float64Array): void {
    const { long, short } = footprint;
    const raster = this.level(footprint.level);
    const [across, down] = [raster.width / this.width, raster.height / this.height];
    this.red = this.green = this.blue = 0;
    for (let i = 0; i < long[2]; ++i) {
      const alongLong = (i + 0.5) / long[2] - 0.5;
      for (let j = 0; j < short[2]; ++j) {
        const alongShort = (j + 0.5) / short[2] - 0.5;
        const u = x + alongLong * long[0] + alongShort * short[0];
        const v = y + alongLong * long[1] + alongShort * short[1];
        this.add(raster, u * across - 0.5, v * down - 0.5);
      }
    }
    const share = 1 / (255 * long[2] * short[2]);
    colour[0]! *= this.red * share;
    colour[1]! *= this.green * share;
    colour[2]! *= this.blue * share;
  }

  private level(number: number): Raster {
    while (this.levels.length <= number) this.levels.push(halved(this.levels.at(-1)!));
    return this.levels[number]!;
  }

  /** Adds the colour between the middles of four pixels. */
  private add({ width, height, rgb }: Raster, x: number, y: number): void {
    const [column, row] = [Math.floor(x), Math.floor(y)];
    const [right, lower] = [x - column, y - row];
    const x0 = 3 * wrapped(column, width, this.wrap[0]);
    const x1 = 3 * wrapped(column + 1, width, this.wrap[0]);
    const y0 = 3 * width * wrapped(row, height, this.wrap[1]);
    const y1 = 3 * width * wrapped(row + 1, height, this.wrap[1]);
    this.addPixel(rgb, y0 + x0, (1 - right) * (1 - lower));
    this.addPixel(rgb, y0 + x1, right * (1 - lower));
    this.addPixel(rgb, y1 + x0, (1 - right) * lower);
    this.addPixel(rgb, y1 + x1, right * lower);
  }

  private addPixel(rgb: Uint8Array, at: number, share: number): void {
    this.red += share * rgb[at]!;
    this.green += share * rgb[at + 1]!;
    this.blue += share * rgb[at + 2]!;
  }
}
