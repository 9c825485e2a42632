/** Reads back the images of pieces from sheets as SVG has them; nothing here comes from the exporter. */
import { XMLParser } from 'fast-xml-parser';
import { pngPixels, type Pixels } from './png-pixels.js';

export type Point = [x: number, y: number];

/** An image on a sheet: mm from the sheet's lower left, y up. */
export interface SheetImage extends Pixels {
  left: number;
  top: number;
  /** Dots to the mm, across and down. */
  density: Point;
}

/** The images of a sheet by the letters of their pieces. */
export function imagesOf(svg: string): Map<string, SheetImage> {
  const parser = new XMLParser({
    ignoreAttributes: false,
    attributeNamePrefix: '',
    isArray: (name) => ['g', 'image'].includes(name),
  });
  type Image = Record<'data-piece' | 'x' | 'y' | 'width' | 'height' | 'xlink:href', string>;
  const parsed = parser.parse(svg) as {
    svg: { height: string; g: { id: string; image?: Image[] }[] };
  };
  const images = parsed.svg.g.find(({ id }) => id === 'texture')?.image ?? [];
  return new Map(
    images.map((image) => {
      const png = new Uint8Array(Buffer.from(image['xlink:href'].split(',')[1]!, 'base64'));
      const pixels = pngPixels(png);
      return [
        image['data-piece'],
        {
          left: Number(image.x),
          top: Number.parseFloat(parsed.svg.height) - Number(image.y),
          density: [pixels.width / Number(image.width), pixels.height / Number(image.height)],
          ...pixels,
        },
      ];
    }),
  );
}

/** A dot's place in the list of values; null beyond the image. */
export function dotIn(
  { left, top, density, width, height }: SheetImage,
  [x, y]: Point,
): number | null {
  const column = Math.floor((x - left) * density[0]);
  const row = Math.floor((top - y) * density[1]);
  return column < 0 || row < 0 || column >= width || row >= height ? null : row * width + column;
}

/** The middle of a dot on the sheet. */
export function middleOf({ left, top, density, width }: SheetImage, dot: number): Point {
  return [
    left + ((dot % width) + 0.5) / density[0],
    top - (Math.floor(dot / width) + 0.5) / density[1],
  ];
}

/** The dots of the box around points, and so many mm beyond. */
export function* dotsIn(
  image: SheetImage,
  points: readonly Point[],
  beyond = 0,
): Generator<number> {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const column = (x: number): number =>
    Math.min(image.width - 1, Math.max(0, Math.floor((x - image.left) * image.density[0])));
  const row = (y: number): number =>
    Math.min(image.height - 1, Math.max(0, Math.floor((image.top - y) * image.density[1])));
  const [from, to] = [column(Math.min(...xs) - beyond), column(Math.max(...xs) + beyond)];
  const last = row(Math.min(...ys) - beyond);
  for (let r = row(Math.max(...ys) + beyond); r <= last; ++r) {
    for (let c = from; c <= to; ++c) yield r * image.width + c;
  }
}

/** Shares of the three corners at a point. */
export function sharesAt(corners: readonly Point[], [x, y]: Point): [number, number, number] {
  const [[ax, ay], [bx, by], [cx, cy]] = corners as [Point, Point, Point];
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  const b = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area;
  const c = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area;
  return [1 - b - c, b, c];
}
