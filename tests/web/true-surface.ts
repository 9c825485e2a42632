/** The surface of a model as another program reads it from its files, and the colour of any place of it. */
import type { Pixels } from './png-pixels.js';

export interface TrueMaterial {
  /** Linear: as light adds up. */
  colour: readonly [number, number, number];
  picture: number | null;
  /** To the right and down. */
  wrap: readonly ['repeat' | 'mirror' | 'clamp', 'repeat' | 'mirror' | 'clamp'];
}

export interface TrueSurface {
  /** 9 per triangle, counter-clockwise from outside. */
  corners: Float64Array;
  /** 6 per triangle: from the picture's left and from its upper edge, 0 to 1; NaN without a picture. */
  places: Float64Array;
  /** 9 per triangle, linear. */
  colours: Float64Array;
  /** Per triangle. */
  materials: Int32Array;
  looks: TrueMaterial[];
  pictures: Pixels[];
}

export type Rgb = [red: number, green: number, blue: number];

/** sRGB, 0 to 255, to light, 0 to 1; and back. */
export function lightOf(value: number): number {
  const share = value / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}

export function shownOf(light: number): number {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);
}

function pixelIndex(index: number, size: number, wrap: TrueMaterial['wrap'][number]): number {
  if (wrap === 'clamp') return Math.min(size - 1, Math.max(0, index));
  const turn = wrap === 'repeat' ? size : 2 * size;
  const within = ((index % turn) + turn) % turn;
  return within < size ? within : turn - 1 - within;
}

/** What a picture shows between the middles of four pixels, before white; 0 to 255. */
function pictureAt(pixels: Pixels, u: number, v: number, wrap: TrueMaterial['wrap']): Rgb {
  const [x, y] = [u * pixels.width - 0.5, v * pixels.height - 0.5];
  const [x0, y0] = [Math.floor(x), Math.floor(y)];
  const sum: Rgb = [0, 0, 0];
  for (const [dx, dy] of [
    [0, 0],
    [1, 0],
    [0, 1],
    [1, 1],
  ] as const) {
    const share = (dx ? x - x0 : 1 - x + x0) * (dy ? y - y0 : 1 - y + y0);
    const column = pixelIndex(x0 + dx, pixels.width, wrap[0]);
    const row = pixelIndex(y0 + dy, pixels.height, wrap[1]);
    const at = 4 * (row * pixels.width + column);
    const cover = pixels.rgba[at + 3]! / 255;
    for (let i = 0; i < 3; ++i) sum[i]! += share * (255 + (pixels.rgba[at + i]! - 255) * cover);
  }
  return sum;
}

/** The colour of a triangle at shares of its second and third corner; sRGB, 0 to 255. */
export function colourAt(surface: TrueSurface, triangle: number, b: number, c: number): Rgb {
  const a = 1 - b - c;
  const mixed = (list: Float64Array, width: number, i: number): number => {
    const at = 3 * width * triangle + i;
    return a * list[at]! + b * list[at + width]! + c * list[at + 2 * width]!;
  };
  const { colour, picture, wrap } = surface.looks[surface.materials[triangle]!]!;
  const [u, v] = [mixed(surface.places, 2, 0), mixed(surface.places, 2, 1)];
  const pixels = picture === null || Number.isNaN(u + v) ? null : surface.pictures[picture]!;
  const shown = pixels ? pictureAt(pixels, u, v, wrap) : [255, 255, 255];
  return [0, 1, 2].map((i) =>
    shownOf(Math.min(1, lightOf(shown[i]!) * colour[i]! * mixed(surface.colours, 3, i))),
  ) as Rgb;
}
