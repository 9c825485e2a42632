import type { Model, Piece } from '../../model/job.js';
import type { Looks } from '../../model/looks.js';
import type { FlapBleed } from '../../model/print-options.js';
import type { Raster } from './raster.js';
import type { Surface } from './surface-look.js';

/** What the pieces of a result are painted from. */
export interface PaintPlan {
  model: Model;
  /** The surface as it was before it was simplified; null if that is the model's own. */
  original: Surface | null;
  /** Of the original, or of the model; null where faces have the colours of their pieces. */
  looks: Looks | null;
  /** By number; null for those that are not to be had. */
  pictures: readonly (Raster | null)[];
  /** Whether the light that the original has is printed, too. */
  isShaded: boolean;
  /** Where there are no looks. */
  colourOf: (piece: Piece) => readonly number[];
  /** Dots to the inch. */
  dpi: number;
  flapBleed: FlapBleed;
}
