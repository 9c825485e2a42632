import type { AssemblyStep } from './assembly-steps.js';
import { edgeLength } from './borders.js';
import type { JobResult, Piece } from './job.js';

/**
 * What a careful person needs, in seconds. Calibrated with the three models that Xi et al. built with glue
 * (1000, 2000 and 3000 triangles in 12, 21 and 36 hours) and the one of 344 triangles that Takahashi et al.
 * taped in about an hour; see docs/paper.md.
 */
export const seconds = {
  /** To find a piece, to cut around it and to hold it while it dries. */
  piece: 180,
  /** Scissors along 1 mm of outline. */
  cutMillimetre: 0.1,
  /** To score and crease a fold. */
  fold: 6,
  /** To glue one seam, with the time until it holds. */
  glue: 60,
  /** To tape it instead. */
  tape: 10,
} as const;

/** Seconds that it takes to build a model, if all its seams are glued, and if all are taped. */
export interface BuildingTime {
  glued: number;
  taped: number;
}

/** Length of all cut edges of a piece in mm. */
function outlineOf(piece: Piece): number {
  let sum = 0;
  for (let edge = 0; edge < piece.assignments.length; ++edge) {
    if (piece.assignments[edge] === 'B') sum += edgeLength(piece, edge);
  }
  return sum;
}

/** How long it takes to build a model; see `seconds`. */
export function buildingTime(
  { pieces, seams }: Pick<JobResult, 'pieces' | 'seams'>,
  steps: readonly Pick<AssemblyStep, 'folds'>[],
): BuildingTime {
  const cuts = pieces.reduce((sum, piece) => sum + outlineOf(piece), 0);
  const folds = steps.reduce((sum, step) => sum + step.folds, 0);
  const first = seconds.piece * pieces.length + seconds.cutMillimetre * cuts + seconds.fold * folds;
  return { glued: first + seconds.glue * seams.length, taped: first + seconds.tape * seams.length };
}

/** How hard a model is to build. */
export type Difficulty = 'easy' | 'medium' | 'hard';

/** Seconds up to which a model is easy, an afternoon, and medium, a weekend; more is hard. */
const limits = { easy: 2 * 3600, medium: 6 * 3600 } as const;

/** How hard a model is, by the time that it takes when its seams are glued: nothing else is known to matter as much. */
export function difficultyOf(glued: number): Difficulty {
  if (glued <= limits.easy) return 'easy';
  return glued <= limits.medium ? 'medium' : 'hard';
}
