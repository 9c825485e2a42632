import type { AssemblyStep } from '../model/assembly-steps.js';
import { seamsByEdge } from '../export/seam-numbers.js';
import type { JobResult } from '../model/job.js';
import type { Words } from '../words/words.js';

/**
 * A step in sentences; what `these` and the numbers are is shown on the sheets. Edges are counted as they are numbered
 * there: what lies in a straight line between two flat faces is one, however many edges the model has along it.
 */
export function stepWords(
  { steps }: Words,
  { borders, crease, folds, partners, seams, turn }: AssemblyStep,
  result: Pick<JobResult, 'pieces' | 'seams'>,
): string {
  const { pieces } = result;
  const seamAt = seamsByEdge(result);
  const glued = new Set(
    borders.map(([{ piece, edge }]) => seamAt.get(pieces[piece]!.modelEdges[edge]!)),
  );
  const letters = partners.map((piece) => pieces[piece]!.name);
  return [
    steps.crease({ folds, crease, turn: turn.length }),
    ...(seams.length > 0 ? [steps.close(seams.length)] : []),
    ...(borders.length > 0 ? [steps.glue(letters, glued.size)] : []),
  ].join(' ');
}
