/** How a model is built, once for all pages that tell of it. */
import { assemblySteps, type AssemblyStep } from '../model/assembly-steps.js';
import { borderOrder, type Border } from '../model/border-order.js';
import type { CutSide } from '../model/borders.js';
import type { JobResult, NamedSeam } from '../model/job.js';
import type { EdgeList } from '../words/building.js';
import { numberRuns, seamNumbers, seamsByEdge } from './seam-numbers.js';

/** What is done with one piece, in order. */
export interface BuildingStep extends AssemblyStep {
  /** Pairs of edges of the piece, in the order in which they are closed. */
  closed: Border[];
  /** Pairs with pieces before it, in the order in which they are glued. */
  glued: Border[];
}

export interface BuildingPlan {
  steps: BuildingStep[];
  /** Printed at seams, by edge of the model. */
  numbers: ReadonlyMap<number, string>;
  /** By edge of the model. */
  seamAt: ReadonlyMap<number, NamedSeam>;
  seams: number;
  /** Folds that are drawn, per piece and kind. */
  folds: { mountains: number; valleys: number }[];
}

/** Folds between faces that a piece shows as lines. */
function foldsOf(
  { assignments, foldAngles }: JobResult['pieces'][number],
  flatFold: number,
): { mountains: number; valleys: number } {
  const count = (kind: 'M' | 'V'): number =>
    [...assignments].filter((letter, i) => letter === kind && Math.abs(foldAngles[i]!) >= flatFold)
      .length;
  return { mountains: count('M'), valleys: count('V') };
}

/** @param flatFold folds flatter than this many degrees are not drawn */
export function buildingPlan(result: JobResult, flatFold: number): BuildingPlan {
  const { pieces } = result;
  const steps = assemblySteps(pieces, flatFold).map((step): BuildingStep => ({
    ...step,
    closed: step.seams.flat().map(([a, b]): Border => [
      { piece: step.piece, edge: a },
      { piece: step.piece, edge: b },
    ]),
    glued: borderOrder(result, step),
  }));
  return {
    steps,
    numbers: seamNumbers(result),
    seamAt: seamsByEdge(result),
    seams: result.seams.length,
    folds: pieces.map((piece) => foldsOf(piece, flatFold)),
  };
}

/** The number that is printed at a seam. */
export function numberOf(
  { pieces }: JobResult,
  { numbers }: BuildingPlan,
  [{ piece, edge }]: Border,
): string | undefined {
  return numbers.get(pieces[piece]!.modelEdges[edge]!);
}

/** Edges in the words of their numbers. */
export function edgeList(
  result: JobResult,
  plan: BuildingPlan,
  borders: readonly Border[],
): EdgeList {
  const all = borders.map((border) => numberOf(result, plan, border));
  const numbers = all.filter((number) => number !== undefined);
  const seamOf = ([{ piece, edge }]: Border): NamedSeam | undefined =>
    plan.seamAt.get(result.pieces[piece]!.modelEdges[edge]!);
  const bare = borders.filter((_, i) => all[i] === undefined);
  return {
    runs: numberRuns(numbers),
    first: all[0] ?? null,
    last: all.at(-1) ?? null,
    edges: new Set(borders.map(seamOf)).size,
    unnumbered: new Set(bare.map(seamOf)).size,
  };
}

/** The side of a border that is on this piece. */
export function sideOn([a, b]: Border, piece: number): CutSide {
  return a.piece === piece ? a : b;
}

/** The piece that a border leads to from this one. */
export function partnerOf([a, b]: Border, piece: number): number {
  return a.piece === piece ? b.piece : a.piece;
}
