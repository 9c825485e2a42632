/**
 * Takes the images of printed sheets back onto the model through its nets, and compares them with the colours that
 * the surface has there by itself. Knows nothing of what paints them.
 */
import type { JobResult, Piece } from '../../web/model/job.js';
import {
  dotIn,
  dotsIn,
  imagesOf,
  middleOf,
  sharesAt,
  type Point,
  type SheetImage,
} from './sheet-images.js';
import { SurfaceSearch, type Vector } from './surface-search.js';
import type { Rgb, TrueSurface } from './true-surface.js';

export interface TextureFigures {
  /** Dots that were compared; at most some of each face. */
  dots: number;
  /** Over faces, the mean of the largest difference of the three channels, 0 to 255. */
  mean: number;
  /** Of the face that differs most in the mean. */
  worst: number;
  /** Percent of the area of all faces whose dots are off by more than `offBy`. */
  off: number;
  /** Percent of the dots of faces that have no colour. */
  bare: number;
  /** Percent of the dots up to 0.4 mm beyond cuts that have none. */
  bareBleed: number;
  /** Percent of the dots on the halves of flaps next to their folds that have none. */
  bareFlaps: number;
  /** Mean difference between dots 0.35 mm beyond a cut and those that lie within the face beside them. */
  bleed: number;
  /** Mean distance of the compared points from the surface, in percent of the model's size. */
  distance: number;
}

/** A difference that is seen side by side. */
export const offBy = 16;

/** Of each face, spread evenly; as many tell its mean well. */
const mostDots = 64;
/** Along each side of a dot: the surface's mean over it is what can be printed. */
const steps = 3;

/** Of what a whole print comes to. */
interface Sums {
  dots: number;
  faces: number;
  differences: number;
  worst: number;
  area: number;
  areaOff: number;
  distances: number;
  covered: Share;
  bleed: Share;
  flaps: Share;
  bled: number[];
}

/** Some of all. */
interface Share {
  some: number;
  all: number;
}

const none = (): Share => ({ some: 0, all: 0 });

const percent = ({ some, all }: Share): number => (all === 0 ? 0 : (100 * some) / all);

const largest = (one: ArrayLike<number>, other: ArrayLike<number>): number =>
  Math.max(...[0, 1, 2].map((i) => Math.abs(one[i]! - other[i]!)));

function vertexOf({ vertices, x, y }: Piece, vertex: number): Point {
  return [x + vertices[2 * vertex]!, y + vertices[2 * vertex + 1]!];
}

function cornersOf(piece: Piece, face: number): Point[] {
  return [0, 1, 2].map((i) => vertexOf(piece, piece.faces[3 * face + i]!));
}

function areaOf(corners: readonly Point[]): number {
  const [[ax, ay], [bx, by], [cx, cy]] = corners as [Point, Point, Point];
  return Math.abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
}

const rgbOf = ({ rgba }: SheetImage, dot: number): Rgb => [
  rgba[4 * dot]!,
  rgba[4 * dot + 1]!,
  rgba[4 * dot + 2]!,
];

/** Compares the printed pieces of one model. */
class TextureCheck {
  readonly sums: Sums = {
    dots: 0,
    faces: 0,
    differences: 0,
    worst: 0,
    area: 0,
    areaOff: 0,
    distances: 0,
    covered: none(),
    bleed: none(),
    flaps: none(),
    bled: [],
  };
  private readonly search: SurfaceSearch;

  constructor(
    private readonly result: JobResult,
    surface: TrueSurface,
  ) {
    this.search = new SurfaceSearch(surface, result.model.vertices, result.deviation);
  }

  add(piece: Piece, image: SheetImage): void {
    /** Dots on faces. */
    const onFaces = new Uint8Array(image.width * image.height);
    for (let face = 0; face < piece.sources.length; ++face)
      this.addFace(piece, face, image, onFaces);
    this.addBleed(piece, image, onFaces);
    this.addFlaps(piece, image, onFaces);
  }

  private addFace(piece: Piece, face: number, image: SheetImage, onFaces: Uint8Array): void {
    const corners = cornersOf(piece, face);
    const inside: number[] = [];
    for (const dot of dotsIn(image, corners)) {
      if (sharesAt(corners, middleOf(image, dot)).every((share) => share > 1e-6)) inside.push(dot);
    }
    this.sums.covered.all += inside.length;
    for (const dot of inside) {
      onFaces[dot] = 1;
      if (image.rgba[4 * dot + 3] !== 255) ++this.sums.covered.some;
    }
    const every = Math.max(1, Math.ceil(inside.length / mostDots));
    const compared = inside.filter((_, i) => i % every === every >> 1);
    if (compared.length === 0) return;
    const found = this.search.near(this.modelCorners(piece.sources[face]!));
    const differences = compared.map((dot) => this.difference(corners, dot, image, found));
    const off = differences.filter((difference) => difference > offBy).length;
    const mean = differences.reduce((sum, value) => sum + value, 0) / differences.length;
    const area = areaOf(corners);
    this.sums.dots += compared.length;
    this.sums.faces += 1;
    this.sums.differences += mean;
    this.sums.worst = Math.max(this.sums.worst, mean);
    this.sums.area += area;
    this.sums.areaOff += (area * off) / compared.length;
  }

  private modelCorners(face: number): Vector[] {
    const { faces, vertices } = this.result.model;
    return [0, 1, 2].map((i) => {
      const at = 3 * faces[3 * face + i]!;
      return [vertices[at]!, vertices[at + 1]!, vertices[at + 2]!];
    });
  }

  private difference(
    corners: readonly Point[],
    dot: number,
    image: SheetImage,
    near: ReturnType<SurfaceSearch['near']>,
  ): number {
    const [x, y] = middleOf(image, dot);
    const sum: Rgb = [0, 0, 0];
    let count = 0;
    for (let i = 0; i < steps * steps; ++i) {
      const across = ((i % steps) + 0.5) / steps - 0.5;
      const down = (Math.floor(i / steps) + 0.5) / steps - 0.5;
      const point: Point = [x + across / image.density[0], y - down / image.density[1]];
      const shares = sharesAt(corners, point);
      if (shares.some((share) => share < 0)) continue;
      const colour = near.at(shares).colours[0]!;
      for (let channel = 0; channel < 3; ++channel) sum[channel]! += colour[channel]!;
      ++count;
    }
    const printed = rgbOf(image, dot);
    const { colours, distance } = near.at(sharesAt(corners, [x, y]));
    this.sums.distances += distance;
    const mean = sum.map((value) => value / count);
    // Where faces lie upon each other any of them may be the one that is printed.
    const others = colours.slice(1).map((colour) => largest(colour, printed));
    return Math.min(largest(mean, printed), ...others);
  }

  /** Beyond the sides without a neighbour on the piece; flaps are looked at by themselves. */
  private addBleed(piece: Piece, image: SheetImage, onFaces: Uint8Array): void {
    const along = 0.8;
    for (let edge = 0; edge < piece.assignments.length; ++edge) {
      if (piece.assignments[edge] !== 'B') continue;
      const [from, to] = [0, 1].map((end) => vertexOf(piece, piece.edges[2 * edge + end]!)) as [
        Point,
        Point,
      ];
      const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
      const out = this.outwards(piece, edge, from, to);
      const count = Math.floor(length / along);
      for (let i = 0; i < count; ++i) {
        const share = (i + 0.5) / count;
        const at = (beyond: number): number | null =>
          dotIn(image, [
            from[0] + share * (to[0] - from[0]) + beyond * out[0],
            from[1] + share * (to[1] - from[1]) + beyond * out[1],
          ]);
        this.addBledDot(image, onFaces, [at(0.35), at(-1.5 / image.density[0])]);
      }
    }
  }

  private addBledDot(
    image: SheetImage,
    onFaces: Uint8Array,
    [beyond, within]: [number | null, number | null],
  ): void {
    if (beyond !== null && onFaces[beyond] === 1) return;
    ++this.sums.bleed.all;
    const isBare = beyond === null || image.rgba[4 * beyond + 3] !== 255;
    if (isBare) ++this.sums.bleed.some;
    else if (within !== null && onFaces[within] === 1) {
      this.sums.bled.push(largest(rgbOf(image, beyond), rgbOf(image, within)));
    }
  }

  /** Away from the face at an edge; of length one. */
  private outwards(piece: Piece, edge: number, from: Point, to: Point): Point {
    const ends = [piece.edges[2 * edge]!, piece.edges[2 * edge + 1]!];
    const face = Array.from(piece.sources).findIndex((_, i) => {
      const corners = piece.faces.subarray(3 * i, 3 * i + 3);
      return ends.every((end) => corners.includes(end));
    });
    const third = piece.faces.subarray(3 * face, 3 * face + 3).find((v) => !ends.includes(v))!;
    const [x, y] = vertexOf(piece, third);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const [nx, ny] = [(to[1] - from[1]) / length, (from[0] - to[0]) / length];
    const sign = nx * (x - from[0]) + ny * (y - from[1]) > 0 ? -1 : 1;
    return [sign * nx, sign * ny];
  }

  /** The half next to the fold of each flap, as is usual. */
  private addFlaps(piece: Piece, image: SheetImage, onFaces: Uint8Array): void {
    const { corners, edges } = piece.flaps;
    for (let flap = 0; flap < edges.length; ++flap) {
      const point = (i: number): Point => [
        piece.x + corners[8 * flap + 2 * i]!,
        piece.y + corners[8 * flap + 2 * i + 1]!,
      ];
      const [foot, top, otherTop, otherFoot] = [point(0), point(1), point(2), point(3)];
      const half = (a: Point, b: Point): Point => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
      const walk = [foot, half(foot, top), half(otherFoot, otherTop), otherFoot];
      for (const triangle of [walk.slice(0, 3), [walk[0]!, walk[2]!, walk[3]!]]) {
        for (const dot of dotsIn(image, triangle)) {
          const isIn = sharesAt(triangle, middleOf(image, dot)).every((share) => share > 1e-6);
          if (!isIn || onFaces[dot] === 1) continue;
          ++this.sums.flaps.all;
          if (image.rgba[4 * dot + 3] !== 255) ++this.sums.flaps.some;
        }
      }
    }
  }

  get size(): number {
    return this.search.size;
  }
}

/**
 * Compares sheets with the surface of their model.
 *
 * @param sheets as SVG, with flaps coloured to their half
 * @throws if a piece has no image
 */
export function checkTexture(
  result: JobResult,
  sheets: readonly string[],
  surface: TrueSurface,
): TextureFigures {
  const check = new TextureCheck(result, surface);
  const images = sheets.map(imagesOf);
  for (const piece of result.pieces) {
    const image = images[piece.sheet]!.get(piece.name);
    if (!image) throw new Error(`${piece.name} has no image`);
    check.add(piece, image);
  }
  const { sums } = check;
  return {
    dots: sums.dots,
    mean: sums.differences / sums.faces,
    worst: sums.worst,
    off: (100 * sums.areaOff) / sums.area,
    bare: percent(sums.covered),
    bareBleed: percent(sums.bleed),
    bareFlaps: percent(sums.flaps),
    bleed: sums.bled.reduce((sum, value) => sum + value, 0) / Math.max(1, sums.bled.length),
    distance: (100 * sums.distances) / sums.dots / check.size,
  };
}
