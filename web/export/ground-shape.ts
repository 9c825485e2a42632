import type { PictureShape } from './picture-shape.js';
import type { Point } from './point.js';
import type { PieceImage } from './texture/piece-images.js';

/** A picture on a sheet. */
export interface PlacedImage {
  kind: 'image';
  /** Its lower left and its upper right corner. */
  corners: [Point, Point];
  image: PieceImage;
}

/** What a piece is coloured with, below its lines. */
export type GroundShape = PictureShape | PlacedImage;

/** Whether lines of a piece lie on a picture, which may be as dark as they are. */
export function isPictured({ ground }: { ground: readonly GroundShape[] }): boolean {
  return ground.some(({ kind }) => kind === 'image');
}
