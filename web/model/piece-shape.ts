import type { Piece } from './job.js';
import type { SheetPoint } from './sheet-edges.js';
import type { Area } from './sheet-room.js';

/** Where a piece lies: its sheet, from 0, the lower left of its box there in mm, and its turn. */
export interface PiecePlace {
  sheet: number;
  x: number;
  y: number;
  /** Degrees, counter-clockwise, from how its net came: as `angle` of a `Piece`. */
  turn: number;
}

/** A convex polygon, counter-clockwise. */
type Polygon = readonly SheetPoint[];

/** How a piece gets from where it lies in the result to another place: turned about a point of its sheet, then moved. */
export interface PieceMotion {
  about: SheetPoint;
  /** Counter-clockwise. */
  degrees: number;
  by: SheetPoint;
}

/** A piece where it lies, with boxes that tell most of it apart from others. */
export interface PlacedShape {
  polygons: readonly Polygon[];
  /** Of each polygon. */
  boxes: readonly Area[];
  box: Area;
}

/** Less than this is no overlap, mm: the engine, which has the last word, bears 0.01. */
const slack = 0.005;

function areaAround(points: Iterable<SheetPoint>): Area {
  const area = { left: Infinity, bottom: Infinity, right: -Infinity, top: -Infinity };
  for (const [x, y] of points) {
    area.left = Math.min(area.left, x);
    area.bottom = Math.min(area.bottom, y);
    area.right = Math.max(area.right, x);
    area.top = Math.max(area.top, y);
  }
  return area;
}

function meet(a: Area, b: Area): boolean {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

/** Whether an area lies within another one. */
export function isWithin(area: Area, room: Area): boolean {
  return (
    area.left >= room.left - slack &&
    area.bottom >= room.bottom - slack &&
    area.right <= room.right + slack &&
    area.top <= room.top + slack
  );
}

/** How far a point lies at the left of a line, times its length. */
function leftOf([x, y]: SheetPoint, [ax, ay]: SheetPoint, [bx, by]: SheetPoint): number {
  return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
}

/** Whether a line along some side of a polygon has the whole other polygon beyond it. */
function isParted(polygon: Polygon, other: Polygon): boolean {
  return polygon.some((from, i) => {
    const to = polygon[(i + 1) % polygon.length]!;
    const least = slack * Math.hypot(to[0] - from[0], to[1] - from[1]);
    // A side without length has nothing beyond it.
    return least > 0 && other.every((point) => leftOf(point, from, to) <= least);
  });
}

/** Whether two pieces overlap where they lie, by more than a hair. */
export function overlap(a: PlacedShape, b: PlacedShape): boolean {
  if (!meet(a.box, b.box)) return false;
  const near = b.polygons.flatMap((polygon, i) =>
    meet(b.boxes[i]!, a.box) ? [{ polygon, box: b.boxes[i]! }] : [],
  );
  return a.polygons.some((own, i) =>
    near.some(
      ({ polygon, box }) =>
        meet(a.boxes[i]!, box) && !isParted(own, polygon) && !isParted(polygon, own),
    ),
  );
}

/** Whether a point lies on a piece. */
export function isOn({ polygons, boxes }: PlacedShape, point: SheetPoint): boolean {
  const [x, y] = point;
  return polygons.some((polygon, at) => {
    const { left, bottom, right, top } = boxes[at]!;
    if (x < left || x > right || y < bottom || y > top) return false;
    return polygon.every((from, i) => leftOf(point, from, polygon[(i + 1) % polygon.length]!) >= 0);
  });
}

/** What of a piece takes up paper: its faces and its flaps, as it lies in the result, from its lower left. */
function polygonsOf({ faces, vertices, flaps: { corners } }: Piece): Polygon[] {
  const polygons: Polygon[] = [];
  for (let at = 0; at < faces.length; at += 3) {
    const point = (corner: number): SheetPoint => {
      const vertex = faces[at + corner]!;
      return [vertices[2 * vertex]!, vertices[2 * vertex + 1]!];
    };
    polygons.push([point(0), point(1), point(2)]);
  }
  for (let at = 0; at < corners.length; at += 8) {
    const point = (corner: number): SheetPoint => [
      corners[at + 2 * corner]!,
      corners[at + 2 * corner + 1]!,
    ];
    polygons.push([point(0), point(1), point(2), point(3)]);
  }
  return polygons;
}

/** The turn that leads to the same place, in (-180, 180] degrees. */
function settledTurn(degrees: number): number {
  const turn = degrees % 360;
  if (turn > 180) return turn - 360;
  return turn <= -180 ? turn + 360 : turn;
}

/** Where a piece lies in the result. */
export function placeOf({ sheet, x, y, angle }: Piece): PiecePlace {
  return { sheet, x, y, turn: angle };
}

/** A piece that can be laid elsewhere. */
export class PieceShape {
  private readonly polygons: readonly Polygon[];

  constructor(private readonly piece: Piece) {
    this.polygons = polygonsOf(piece);
  }

  /** The piece at a place. */
  at({ x, y, turn }: PiecePlace): PlacedShape {
    const turned = this.turned(turn);
    const { left, bottom, right, top } = areaAround(turned.flat());
    const [dx, dy] = [x - left, y - bottom];
    const polygons = turned.map((polygon) => polygon.map(([u, v]): SheetPoint => [u + dx, v + dy]));
    const box = { left: x, bottom: y, right: right + dx, top: top + dy };
    return { polygons, boxes: polygons.map(areaAround), box };
  }

  /** How it gets to a place from where it lies. */
  motionTo({ x, y, turn }: PiecePlace): PieceMotion {
    const { left, bottom } = areaAround(this.turned(turn).flat());
    const about = [this.piece.x, this.piece.y] as const;
    const by = [x - about[0] - left, y - about[1] - bottom] as const;
    return { about, degrees: turn - this.piece.angle, by };
  }

  /** The place turned by so many degrees about the middle of its box, which stays where it is. */
  turnedBy(place: PiecePlace, degrees: number): PiecePlace {
    const turn = settledTurn(place.turn + degrees);
    const { box: before } = this.at(place);
    const { box: after } = this.at({ ...place, turn });
    const x = place.x + (before.right - before.left - (after.right - after.left)) / 2;
    const y = place.y + (before.top - before.bottom - (after.top - after.bottom)) / 2;
    return { ...place, x, y, turn };
  }

  private turned(turn: number): readonly Polygon[] {
    if (turn === this.piece.angle) return this.polygons;
    const angle = ((turn - this.piece.angle) * Math.PI) / 180;
    const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
    const turned = ([x, y]: SheetPoint): SheetPoint => [
      cosine * x - sine * y,
      sine * x + cosine * y,
    ];
    return this.polygons.map((polygon) => polygon.map(turned));
  }
}
