/** What pieces are coloured with, below their lines. */
import type { Piece } from '../model/job.js';
import { partRgb } from '../model/part-colours.js';
import { printsPartColours, type PrintOptions } from '../model/print-options.js';
import type { GroundShape } from './ground-shape.js';
import { hexOf } from './model-picture.js';
import type { Point } from './point.js';
import { bledFlaps, bleedReach } from './texture/flap-bleed.js';
import type { PieceImage } from './texture/piece-images.js';

/** A piece in the colour of its part, half a millimetre beyond its cuts, and of its flaps what is asked for. */
function partGround(piece: Piece, { flapBleed }: PrintOptions): GroundShape[] {
  const at = (vertex: number): Point => [
    piece.x + piece.vertices[2 * vertex]!,
    piece.y + piece.vertices[2 * vertex + 1]!,
  ];
  const walks = piece.outlines.map((outline) => Array.from(outline, at));
  walks.push(...bledFlaps(piece, flapBleed));
  const colour = hexOf([...partRgb(piece.part)] as [number, number, number]);
  const style = { width: 2 * bleedReach, colour, dash: [] };
  return [
    { kind: 'area', colour, walks },
    { kind: 'line', style, walks, closed: true },
  ];
}

function imageGround(image: PieceImage): GroundShape[] {
  const { left, top, width, height, density } = image.grid;
  const corners: [Point, Point] = [
    [left, top - height / density],
    [left + width / density, top],
  ];
  return [{ kind: 'image', corners, image }];
}

/**
 * What a piece is coloured with where it lies on its sheet.
 *
 * @param image in the model's colours, if it is printed so
 */
export function groundOf(
  piece: Piece,
  image: PieceImage | null,
  options: PrintOptions,
): GroundShape[] {
  if (image) return imageGround(image);
  return printsPartColours(options) ? partGround(piece, options) : [];
}
