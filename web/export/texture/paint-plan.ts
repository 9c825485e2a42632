import type { Model } from '../../model/job.js';
import type { Looks } from '../../model/looks.js';
import type { FlapBleed } from '../../model/print-options.js';
import type { Raster } from './raster.js';

/** What the pieces of a result are painted from. */
export interface PaintPlan {
  model: Model;
  looks: Looks;
  /** By number; null for those that are not to be had. */
  pictures: readonly (Raster | null)[];
  /** Dots to the inch. */
  dpi: number;
  flapBleed: FlapBleed;
}
