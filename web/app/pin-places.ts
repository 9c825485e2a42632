import { isPinOf } from '../model/piece-edits.js';
import type { JobResult, Piece } from '../model/job.js';
import type { PinnedPiece } from '../model/job-options.js';
import type { PinSign } from '../view/pin-signs.js';

/** Signs of pins by sheet, counted from 0. */
export type PinsBySheet = ReadonlyMap<number, PinSign[]>;

type Point = readonly [x: number, y: number];

const apart = ([ax, ay]: Point, [bx, by]: Point): number => Math.hypot(ax - bx, ay - by);

/** The circle within a triangle. */
function circleIn(corners: readonly [Point, Point, Point]): { at: Point; room: number } {
  const [a, b, c] = corners;
  const sides = [apart(b, c), apart(c, a), apart(a, b)] as const;
  const around = sides[0] + sides[1] + sides[2];
  const mean = (axis: 0 | 1): number =>
    (sides[0] * a[axis] + sides[1] * b[axis] + sides[2] * c[axis]) / around;
  const twice = Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  return { at: [mean(0), mean(1)], room: twice / around };
}

/** The middle of the largest circle in a face of a piece that keeps off the piece's texts, in the piece's coordinates. */
function freePlaceIn({ vertices, faces, labels }: Piece): Point {
  const point = (corner: number): Point => {
    const vertex = 2 * faces[corner]!;
    return [vertices[vertex]!, vertices[vertex + 1]!];
  };
  let best: { at: Point; room: number } = { at: point(0), room: -Infinity };
  for (let face = 0; face < faces.length; face += 3) {
    const { at, room } = circleIn([point(face), point(face + 1), point(face + 2)]);
    const free = labels.reduce(
      (least, { x, y, size }) => Math.min(least, apart(at, [x, y]) - size),
      room,
    );
    if (free > best.room) best = { at, room: free };
  }
  return best.at;
}

/** A sign for each piece that stays where it is. @param title says what it means */
export function pinSigns(
  title: string,
  { pieces }: JobResult,
  pins: readonly PinnedPiece[],
): PinsBySheet {
  const signs = new Map<number, PinSign[]>();
  for (const piece of pieces) {
    if (!pins.some((pin) => isPinOf(pin, piece))) continue;
    const [x, y] = freePlaceIn(piece);
    const sign: PinSign = { title, at: [piece.x + x, piece.y + y] };
    signs.set(piece.sheet, [...(signs.get(piece.sheet) ?? []), sign]);
  }
  return signs;
}
