/**
 * Registration marks of Silhouette machines, which a sensor looks for before it cuts a printed sheet:
 * a filled square at the upper left, and corners of two lines at the upper right and the lower left.
 * docs/paper.md says where their sizes are from.
 */
import { meets, type Box } from './box.js';
import type { Point } from './point.js';
import { isInside, sidesOf } from './polygon.js';
import type { RegistrationMarks, SheetDrawing } from './sheet-drawing.js';

/** Lengths in mm. */
export const registration = {
  /** From all edges of the sheet to the square's outer sides and to the middles of lines. */
  inset: 10,
  square: 5,
  /** Of each of the two lines of a corner. */
  arm: 20,
  width: 0.3,
} as const;

/** Places of the three marks: the outer corner of each, and which way its sheet lies. */
function outerCorners(width: number, height: number): [corner: Point, inwards: Point][] {
  const { inset } = registration;
  return [
    [
      [inset, height - inset],
      [1, -1],
    ],
    [
      [width - inset, height - inset],
      [-1, -1],
    ],
    [
      [inset, inset],
      [1, 1],
    ],
  ];
}

/** The marks of a sheet; mm, y up, from its lower left. */
export function registrationMarks(width: number, height: number): RegistrationMarks {
  const { square, arm } = registration;
  const [[[left, top]], ...others] = outerCorners(width, height) as [
    [Point, Point],
    ...[Point, Point][],
  ];
  return {
    square: [
      [left, top],
      [left, top - square],
      [left + square, top - square],
      [left + square, top],
    ],
    corners: others.map(([[x, y], [right, up]]) => [
      [x + right * arm, y],
      [x, y],
      [x, y + up * arm],
    ]),
    width: registration.width,
  };
}

/** Squares around the marks in which the sensor must see nothing else. */
function quietZones(width: number, height: number): Box[] {
  const half = registration.arm / 2;
  return outerCorners(width, height).map(([[x, y], [right, up]]) => ({
    middle: [x + right * half, y + up * half],
    along: [1, 0],
    halfWidth: half,
    halfHeight: half,
  }));
}

/** Margin that keeps all pieces out of the quiet zones; mm. */
export const quietMargin = registration.inset + registration.arm;

/** Pieces that lie where the sensor looks for its marks, by letter. */
export function piecesInQuietZones({ width, height, pieces }: SheetDrawing): string[] {
  const zones = quietZones(width, height);
  const isIn = (walk: Point[]): boolean =>
    zones.some(
      (zone) => sidesOf(walk).some((side) => meets(zone, side)) || isInside(zone.middle, walk),
    );
  return pieces.filter(({ cuts }) => cuts.some(isIn)).map(({ letter }) => letter);
}
