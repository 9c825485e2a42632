import type { MatrixPicture } from '../model/job.js';
import { FitnessHistory } from '../view/fitness-history.js';

/**
 * What the pictures of a run have to show. It stays with the result: another run may use their place
 * and come to nothing.
 */
export class RunPictures {
  /** The last one; null if nothing was learned. */
  matrix: MatrixPicture | null = null;
  readonly fitness = new FitnessHistory();

  constructor(readonly modelName: string) {}
}
