/** How much of the paper becomes part of the model: what lies inside cut lines, over what can be printed on. */
import type { JobResult, Piece } from './job.js';

/** Area of a polygon, given as x and y of its corners, mm². */
function polygonArea(points: ArrayLike<number>): number {
  let twice = 0;
  for (let i = 0; i < points.length; i += 2) {
    const next = (i + 2) % points.length;
    twice += points[i]! * points[next + 1]! - points[next]! * points[i + 1]!;
  }
  return Math.abs(twice) / 2;
}

function faceAreas({ faces, vertices }: Piece): number {
  let sum = 0;
  for (let i = 0; i < faces.length; i += 3) {
    const corners = [...faces.subarray(i, i + 3)];
    sum += polygonArea(corners.flatMap((v) => [vertices[2 * v]!, vertices[2 * v + 1]!]));
  }
  return sum;
}

/** Area of a piece with its flaps, mm². */
function pieceArea(piece: Piece): number {
  const { corners } = piece.flaps;
  let sum = faceAreas(piece);
  for (let i = 0; i < corners.length; i += 8) sum += polygonArea(corners.subarray(i, i + 8));
  return sum;
}

/**
 * Per sheet the area of its pieces, flaps and loose strips over that within the margins, in [0, 1].
 *
 * @param margin around each sheet, mm
 */
export function sheetFills({ pieces, sheets, strips }: JobResult, margin: number): number[] {
  const used = sheets.map(() => 0);
  for (const piece of pieces) used[piece.sheet]! += pieceArea(piece);
  for (const { sheet, outline } of strips) used[sheet]! += polygonArea(outline);
  return used.map((area, i) => {
    const { width, height } = sheets[i]!;
    return area / ((width - 2 * margin) * (height - 2 * margin));
  });
}

/** The same over all sheets, which are equal: their mean. */
export function paperUse(result: JobResult, margin: number): number {
  const fills = sheetFills(result, margin);
  return fills.reduce((sum, fill) => sum + fill, 0) / fills.length;
}
