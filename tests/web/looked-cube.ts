/** The cube of the fixtures with colours and pictures, and what every point of it looks like. */
import UPNG from '@pdf-lib/upng';
import type { JobResult } from '../../web/model/job.js';
import type { Looks, Material } from '../../web/model/looks.js';
import { cubeResult } from './fixtures.js';

export type Colour = readonly [number, number, number];

/** A PNG file, written by another library. */
export function pngOf(
  width: number,
  height: number,
  colourAt: (x: number, y: number) => readonly number[],
): Uint8Array {
  const rgba = new Uint8Array(4 * width * height);
  for (let i = 0; i < width * height; ++i) {
    rgba.set([...colourAt(i % width, Math.floor(i / width)), 255].slice(0, 4), 4 * i);
  }
  return new Uint8Array(UPNG.encode([rgba.buffer], width, height, 0));
}

export function materialOf(colour: Colour, picture: number | null = null): Material {
  return {
    name: '',
    colour,
    picture,
    wrap: ['repeat', 'repeat'],
    scale: [1, 1],
    offset: [0, 0],
  };
}

/** Of the squares of the cube: bottom, top, front, right, back, left. */
export const sideColours: readonly Colour[] = [
  [200, 30, 30],
  [30, 200, 30],
  [30, 30, 200],
  [200, 200, 30],
  [30, 200, 200],
  [200, 30, 200],
];

/** A cube of which each side has a colour of its own. */
export function colouredCube(): JobResult {
  const looks: Looks = {
    surface: {
      original: null,
      places: null,
      colours: null,
      materials: Int32Array.from({ length: 12 }, (_, face) => face >> 1),
    },
    materials: sideColours.map((colour) => materialOf(colour)),
    pictures: [],
  };
  return { ...cubeResult(), looks };
}

/** Of the picture: upper left, upper right, lower left, lower right. */
export const quadrants: readonly Colour[] = [
  [250, 20, 20],
  [20, 250, 20],
  [20, 20, 250],
  [250, 250, 20],
];

/** Right and up on each square, as somebody sees it who stands before the front with z up. */
const frames: readonly [right: number[], up: number[]][] = [
  [
    [1, 0, 0],
    [0, -1, 0],
  ],
  [
    [1, 0, 0],
    [0, 1, 0],
  ],
  [
    [1, 0, 0],
    [0, 0, 1],
  ],
  [
    [0, 1, 0],
    [0, 0, 1],
  ],
  [
    [-1, 0, 0],
    [0, 0, 1],
  ],
  [
    [0, -1, 0],
    [0, 0, 1],
  ],
];

/** Where a point of a square lies in the picture, from its lower left; 0 to 1. */
export function placeOn(side: number, point: readonly number[]): [u: number, v: number] {
  const along = (axis: readonly number[]): number =>
    axis.reduce((sum, part, i) => sum + part * (point[i]! / 40 - 0.5), 0.5);
  const [right, up] = frames[side]!;
  return [along(right), along(up)];
}

/** A cube with a picture of four quadrants on each side. */
export function picturedCube(): JobResult {
  const result = cubeResult();
  const { vertices, faces } = result.model;
  const places = Array.from(faces, (vertex, corner) =>
    placeOn(Math.floor(corner / 6), [...vertices.subarray(3 * vertex, 3 * vertex + 3)]),
  );
  const looks: Looks = {
    surface: {
      original: null,
      places: Float32Array.from(places.flat()),
      colours: null,
      materials: new Int32Array(12),
    },
    materials: [materialOf([255, 255, 255], 0)],
    pictures: [
      {
        name: 'quadrants.png',
        bytes: pngOf(32, 32, (x, y) => quadrants[(x >> 4) + 2 * (y >> 4)]!),
      },
    ],
  };
  return { ...result, looks };
}
