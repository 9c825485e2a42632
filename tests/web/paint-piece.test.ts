import { beforeAll, describe, expect, it } from 'vitest';
import { startRenderer } from '../../web/export/renderer.js';
import { bledFlaps } from '../../web/export/texture/flap-bleed.js';
import { loadPictures } from '../../web/export/texture/load-pictures.js';
import { PiecePainter, type PaintedPiece } from '../../web/export/texture/paint-piece.js';
import type { JobResult } from '../../web/model/job.js';
import { lightOf, shownOf } from '../../web/model/srgb.js';
import type { FlapBleed } from '../../web/model/print-options.js';
import {
  colouredCube,
  materialOf,
  picturedCube,
  placeOn,
  quadrants,
  sideColours,
  type Colour,
} from './looked-cube.js';
import { readRenderer } from './printed.js';

interface Wish {
  dpi?: number;
  flapBleed?: FlapBleed;
}

async function painted(
  { model, looks, pieces }: JobResult,
  { dpi = 100, flapBleed = 'none' }: Wish = {},
): Promise<PaintedPiece> {
  const { pictures } = await loadPictures(looks!, readRenderer);
  const original = looks!.surface.original;
  const plan = { model, original, looks: looks!, pictures, isShaded: false, dpi, flapBleed };
  const painter = new PiecePainter({ ...plan, colourOf: () => [255, 255, 255] });
  return painter.paint(pieces[0]!, painter.gridOf(pieces[0]!, 297));
}

interface Dot {
  /** Of its middle, on the sheet. */
  x: number;
  y: number;
  colour: Colour;
  alpha: number;
}

function* dotsOf({ width, height, left, top, density, rgba }: PaintedPiece): Generator<Dot> {
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      const at = 4 * (row * width + column);
      yield {
        x: left + (column + 0.5) / density,
        y: top - (row + 0.5) / density,
        colour: [rgba[at]!, rgba[at + 1]!, rgba[at + 2]!],
        alpha: rgba[at + 3]!,
      };
    }
  }
}

interface Found {
  /** Of the model. */
  face: number;
  point: number[];
}

/** A dot on a face of the piece. */
type FaceDot = Dot & Found;

/** The dots on the faces of the only piece for which `isWrong` is true; and how many dots there are. */
function wrongDots(
  result: JobResult,
  painting: PaintedPiece,
  isWrong: (dot: FaceDot) => boolean,
): { wrong: FaceDot[]; count: number } {
  const wrong: FaceDot[] = [];
  let count = 0;
  for (const dot of dotsOf(painting)) {
    const found = modelAt(result, dot.x, dot.y);
    if (!found) continue;
    ++count;
    if (dot.alpha !== 255 || isWrong({ ...dot, ...found })) wrong.push({ ...dot, ...found });
  }
  return { wrong, count };
}

/** The face of a piece at a place of the sheet, and the point of the model that lies there. */
function modelAt({ model, pieces }: JobResult, x: number, y: number): Found | null {
  const piece = pieces[0]!;
  for (let i = 0; i < piece.sources.length; ++i) {
    const corners = [0, 1, 2].map((corner) => {
      const vertex = piece.faces[3 * i + corner]!;
      return [
        piece.x + piece.vertices[2 * vertex]!,
        piece.y + piece.vertices[2 * vertex + 1]!,
      ] as const;
    });
    const shares = [0, 1, 2].map((corner) => {
      const [[ax, ay], [bx, by]] = [corners[(corner + 1) % 3]!, corners[(corner + 2) % 3]!];
      return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    });
    const sum = shares.reduce((total, share) => total + share);
    if (shares.some((share) => share < 0)) continue;
    const face = piece.sources[i]!;
    const point = [0, 1, 2].map((axis) =>
      shares.reduce(
        (total, share, corner) =>
          total + (share / sum) * model.vertices[3 * model.faces[3 * face + corner]! + axis]!,
        0,
      ),
    );
    return { face, point };
  }
  return null;
}

/** How far a place lies from all faces of the only piece. */
function wayTo({ pieces }: JobResult, x: number, y: number): number {
  const { vertices, edges, x: left, y: bottom } = pieces[0]!;
  let least = Infinity;
  for (let edge = 0; edge < edges.length / 2; ++edge) {
    const [from, to] = [edges[2 * edge]!, edges[2 * edge + 1]!];
    const [ax, ay] = [left + vertices[2 * from]!, bottom + vertices[2 * from + 1]!];
    const [dx, dy] = [vertices[2 * to]! + left - ax, vertices[2 * to + 1]! + bottom - ay];
    const along = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
    const share = Math.max(0, Math.min(1, along));
    least = Math.min(least, Math.hypot(x - ax - share * dx, y - ay - share * dy));
  }
  return least;
}

const difference = (one: Colour, other: Colour): number =>
  Math.max(...one.map((value, i) => Math.abs(value - other[i]!)));

beforeAll(() => startRenderer(readRenderer));

describe('PiecePainter', () => {
  it('gives every dot the colour of its face', async () => {
    const cube = colouredCube();
    const painting = await painted(cube);
    const { wrong, count } = wrongDots(
      cube,
      painting,
      ({ x, y, face, colour }) =>
        difference(colour, sideColours[face >> 1]!) > 0 && wayTo(cube, x, y) > 0.01,
    );
    expect(wrong).toEqual([]);
    // Six squares of 40 mm.
    expect(Math.abs(count / painting.density ** 2 - 9600)).toBeLessThan(60);
  });

  it('goes half a millimetre beyond cuts, and no farther', async () => {
    const cube = colouredCube();
    const painting = await painted(cube);
    const dot = 1 / painting.density;
    const wrong: Dot[] = [];
    const counts = { near: 0, far: 0 };
    for (const place of dotsOf(painting)) {
      if (modelAt(cube, place.x, place.y)) continue;
      const way = wayTo(cube, place.x, place.y);
      if (way >= 0.5 && way < 0.5 + dot) continue;
      const isNear = way < 0.5;
      ++counts[isNear ? 'near' : 'far'];
      const isRight = isNear
        ? place.alpha === 255 && sideColours.some((side) => difference(side, place.colour) === 0)
        : place.alpha === 0;
      if (!isRight) wrong.push(place);
    }
    expect(wrong).toEqual([]);
    expect(counts.near).toBeGreaterThan(14 * 40 * (0.5 - dot) * painting.density ** 2 * 0.7);
    expect(counts.far).toBeGreaterThan(counts.near);
  });

  it.each([72, 200])('puts pictures in their place, right side up, at %i dpi', async (dpi) => {
    const cube = picturedCube();
    let seen = 0;
    const { wrong } = wrongDots(cube, await painted(cube, { dpi }), ({ face, point, colour }) => {
      const [u, v] = placeOn(face >> 1, point);
      // Between two quadrants, and at the edges, the picture goes over from one pixel to the next.
      const nearest = Math.min(...[u, v].flatMap((at) => [at, 1 - at, Math.abs(at - 0.5)]));
      if (nearest < 1 / 32 + 0.02) return false;
      ++seen;
      return difference(colour, quadrants[+(u > 0.5) + 2 * +(v < 0.5)]!) > 1;
    });
    expect(wrong).toEqual([]);
    expect(seen * (25.4 / dpi) ** 2).toBeGreaterThan(5000);
  });

  it('multiplies colours of materials, corners and pictures', async () => {
    const cube = picturedCube();
    const looks = cube.looks!;
    looks.materials = [materialOf([128, 255, 0], 0)];
    looks.surface.colours = new Uint8Array(108).fill(51);
    const product: Colour = [(250 * 128 * 51) / 255 / 255, (20 * 51) / 255, 0];
    const { wrong } = wrongDots(cube, await painted(cube), ({ face, point, colour }) => {
      const [u, v] = placeOn(face >> 1, point);
      return Math.hypot(u - 0.25, v - 0.75) < 0.1 && difference(colour, product) > 1;
    });
    expect(wrong).toEqual([]);
  });

  it('lets colours of corners run into each other', async () => {
    const cube = colouredCube();
    const { faces, vertices } = cube.model;
    const looks = cube.looks!;
    looks.surface.materials = null;
    looks.surface.colours = Uint8Array.from(
      Array.from(faces).flatMap((vertex) =>
        [0, 1, 2].map((axis) => 6 * vertices[3 * vertex + axis]!),
      ),
    );
    const { wrong } = wrongDots(cube, await painted(cube, { dpi: 72 }), ({ point, colour }) => {
      // As light does: the middle of black and white is no middle grey.
      const [red, green, blue] = point.map((at) => 255 * shownOf((at / 40) * lightOf(240 / 255)));
      return difference(colour, [red!, green!, blue!]) > 1;
    });
    expect(wrong).toEqual([]);
  });

  it('scales, moves and repeats pictures', async () => {
    const cube = picturedCube();
    cube.looks!.materials = [
      { ...materialOf([255, 255, 255], 0), scale: [2, 2], offset: [0.5, 0] },
    ];
    const { wrong } = wrongDots(cube, await painted(cube), ({ face, point, colour }) => {
      const [u, v] = placeOn(face >> 1, point);
      const [right, up] = [(2 * u + 0.5) % 1, (2 * v) % 1];
      const isWithin = Math.abs(right - 0.25) < 0.1 && Math.abs(up - 0.25) < 0.1;
      return isWithin && difference(colour, quadrants[2]!) > 1;
    });
    expect(wrong).toEqual([]);
  });

  it('shows the material where a face has no place in its picture, or the picture is lacking', async () => {
    const plain: Colour = [90, 120, 150];
    const cube = picturedCube();
    cube.looks!.materials = [materialOf(plain, 0)];
    cube.looks!.surface.places!.fill(NaN);
    const lacking = picturedCube();
    lacking.looks!.materials = [materialOf(plain, 0)];
    lacking.looks!.pictures = [{ name: 'a.tga', bytes: new Uint8Array(3) }];
    for (const result of [cube, lacking]) {
      const painting = await painted(result, { dpi: 72 });
      const isWrong = ({ colour }: FaceDot): boolean => difference(colour, plain) > 0;
      expect(wrongDots(result, painting, isWrong).wrong).toEqual([]);
    }
  });

  it('takes from the surface before it was simplified what lies nearest', async () => {
    const direct = picturedCube();
    const baked = picturedCube();
    const { vertices, faces } = baked.model;
    // A little larger all around, with its faces in another order.
    const order = Array.from({ length: 12 }, (_, face) => (face * 5) % 12);
    const pick = (values: ArrayLike<number>, size: number): number[] =>
      order.flatMap((face) => Array.from({ length: size }, (_, i) => values[size * face + i]!));
    baked.looks!.surface = {
      ...baked.looks!.surface,
      original: {
        vertices: vertices.map((value) => 20 + 1.02 * (value - 20)),
        faces: Int32Array.from(pick(faces, 3)),
      },
      places: Float32Array.from(pick(baked.looks!.surface.places!, 6)),
    };
    const [one, other] = [await painted(direct), await painted(baked)];
    let far = 0;
    // Beyond the faces all depends on the dot that is nearest.
    const onFaces = [...dotsOf(one)].map(({ x, y }) => modelAt(direct, x, y) !== null);
    one.rgba.forEach((value, i) => {
      far += Number(onFaces[i >> 2] && Math.abs(value - other.rgba[i]!) > 12);
    });
    expect(far / one.rgba.length).toBeLessThan(0.02);
  });

  it('paints the same every time', async () => {
    const { rgba } = await painted(picturedCube());
    expect(Buffer.compare((await painted(picturedCube())).rgba, rgba)).toBe(0);
  });
});

describe('flaps', () => {
  /** A cube with a flap of 5 mm at the first of its cuts. */
  function flapped(): JobResult {
    const result = colouredCube();
    const piece = result.pieces[0]!;
    const edge = piece.assignments.indexOf('B');
    const [from, to] = [0, 1].map((end) => {
      const vertex = piece.edges[2 * edge + end]!;
      return [piece.vertices[2 * vertex]!, piece.vertices[2 * vertex + 1]!] as const;
    }) as [readonly [number, number], readonly [number, number]];
    const on = (along: number, out: number): number[] => [
      from[0] + (along * (to[0] - from[0]) + out * (to[1] - from[1])) / 40,
      from[1] + (along * (to[1] - from[1]) - out * (to[0] - from[0])) / 40,
    ];
    piece.flaps = {
      edges: Int32Array.of(edge),
      bases: piece.edges.slice(2 * edge, 2 * edge + 2),
      corners: Float64Array.from([on(0, 0), on(6, 5), on(34, 5), on(40, 0)].flat()),
      angles: Float64Array.of(90),
    };
    return result;
  }

  /** Whether the middle of a flap is coloured so high above its base. */
  async function isColoured(flapBleed: FlapBleed, share: number): Promise<boolean[]> {
    const result = flapped();
    const painting = await painted(result, { flapBleed, dpi: 300 });
    const piece = result.pieces[0]!;
    expect(piece.flaps.edges.length).toBeGreaterThan(0);
    return bledFlaps(piece, 'whole').map(([foot, top, otherTop, otherFoot]) => {
      const [x, y] = [0, 1].map((axis) => {
        const base = (foot![axis]! + otherFoot![axis]!) / 2;
        return base + share * ((top![axis]! + otherTop![axis]!) / 2 - base);
      }) as [number, number];
      const { width, height, left, top: upper, density, rgba } = painting;
      const [column, row] = [Math.floor((x - left) * density), Math.floor((upper - y) * density)];
      const isThere = column >= 0 && column < width && row >= 0 && row < height;
      return isThere && rgba[4 * (row * width + column) + 3] === 255;
    });
  }

  it.each([
    ['none', [true, false, false, false]],
    ['half', [true, true, false, false]],
    ['whole', [true, true, true, true]],
  ] as const)('are coloured as far as asked for: %s', async (bleed, expected) => {
    for (const [i, share] of [0.05, 0.45, 0.75, 1].entries()) {
      const coloured = await isColoured(bleed, share);
      expect(coloured).toEqual(coloured.map(() => expected[i]));
    }
  });
});
