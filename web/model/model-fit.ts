/** How a model is laid over a corrected one of another size, so that places of the one are found in the other. */
import { boxOf, type Box3 } from './bounds.js';
import { length, minus, plus, times, vectorAt, type Vector } from './vector.js';

/** A model and how large it was made. */
export interface SizedModel {
  /** 3 per vertex, in mm. */
  vertices: ArrayLike<number>;
  /** Millimetres per unit of its file. */
  scale: number;
}

/**
 * Share of the diagonal of a model's box within which two places are the same: a quarter of the usual edge of a model
 * of 1500 triangles, and far more than vertices move when a file is written again.
 */
export const placeTolerance = 0.01;

/** Vertices that are compared for each fit: they tell enough, and all fits are tried within a second. */
const mostSamples = 150;

/** Ends and middles of boxes that are laid on each other: a correction moves at most one end along most axes. */
const anchors = [0.5, 0, 1] as const;

/** The length of a box's diagonal. */
export function diagonalOf({ low, high }: Box3): number {
  return length(minus(high, low));
}

/** The vertex that is nearest to a point, and its distance. */
export function nearestVertex(
  vertices: ArrayLike<number>,
  [x, y, z]: Vector,
): { vertex: number; distance: number } {
  let [vertex, best] = [-1, Infinity];
  for (let i = 0; i < vertices.length; i += 3) {
    const square =
      (vertices[i]! - x) ** 2 + (vertices[i + 1]! - y) ** 2 + (vertices[i + 2]! - z) ** 2;
    if (square < best) [vertex, best] = [i / 3, square];
  }
  return { vertex, distance: Math.sqrt(best) };
}

/** Grows a model and moves it. */
export class ModelFit {
  /** @param move after growing */
  constructor(
    private readonly factor: number,
    private readonly move: Vector,
  ) {}

  /** Where a point of the model before comes to lie. */
  ahead(point: Vector): Vector {
    return plus(times(point, this.factor), this.move);
  }

  /** Where a point of the model after it would lie in the one before. */
  back(point: Vector): Vector {
    return times(minus(point, this.move), 1 / this.factor);
  }
}

/** The fit that lays two boxes on each other, at a share of their sides along each axis. */
function fitAt(before: Box3, after: Box3, factor: number, shares: Vector): ModelFit {
  const anchorOf = ({ low, high }: Box3): Vector => {
    const [x, y, z] = minus(high, low);
    return plus(low, [shares[0] * x, shares[1] * y, shares[2] * z]);
  };
  return new ModelFit(factor, minus(anchorOf(after), times(anchorOf(before), factor)));
}

function samplesOf({ vertices }: SizedModel): Vector[] {
  const count = vertices.length / 3;
  const step = Math.max(1, Math.floor(count / mostSamples));
  return Array.from({ length: Math.floor((count - 1) / step) + 1 }, (_, i) =>
    vectorAt(vertices, i * step),
  );
}

/**
 * The fit that brings most vertices of a model to vertices of another one. Tried are boxes of the same size and the same
 * units of the files, each with the boxes laid on each other at their middles or ends: so a model is found again that was
 * exported at another size, as well as one that has lost or gained something at an end.
 *
 * Cost: 54 times 150 looks at all vertices. @pre both have a vertex
 */
export function fitOf(before: SizedModel, after: SizedModel): ModelFit {
  const [box, next] = [boxOf(before.vertices), boxOf(after.vertices)];
  const tolerance = placeTolerance * diagonalOf(next);
  const samples = samplesOf(before);
  const scoreOf = (fit: ModelFit): number =>
    samples.reduce((sum, point) => {
      const { distance } = nearestVertex(after.vertices, fit.ahead(point));
      return sum + Math.max(0, 1 - distance / tolerance);
    }, 0);
  const factors = [diagonalOf(next) / diagonalOf(box), after.scale / before.scale];
  const fits = factors.flatMap((factor) =>
    anchors.flatMap((x) =>
      anchors.flatMap((y) => anchors.map((z) => fitAt(box, next, factor, [x, y, z]))),
    ),
  );
  const scores = fits.map(scoreOf);
  return fits[scores.indexOf(Math.max(...scores))]!;
}
