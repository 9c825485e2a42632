import type { AssemblyStep } from '../model/assembly-steps.js';
import type { CutSide } from '../model/borders.js';
import type { JobResult } from '../model/job.js';
import type { MarkKind } from '../view/sheet-marks.js';

/** Edges of the model that a step is about: 2 vertices each, and why. */
export interface ModelMarks {
  edges: Int32Array;
  kinds: readonly MarkKind[];
}

export const noMarks: ModelMarks = { edges: new Int32Array(), kinds: [] };

type Shown = Pick<JobResult, 'model' | 'pieces'>;

/** The vertices of the model at the ends of a piece's edge. */
function endsOf({ model, pieces }: Shown, { piece, edge }: CutSide): [number, number] {
  const { edges, faces, sources } = pieces[piece]!;
  const vertexOf = (end: number): number => {
    const corner = faces.indexOf(end);
    return model.faces[3 * sources[Math.floor(corner / 3)]! + (corner % 3)]!;
  };
  return [vertexOf(edges[2 * edge]!), vertexOf(edges[2 * edge + 1]!)];
}

/** What a step is about, where it lies on the model; each seam once, although it has two sides. */
export function modelMarks(step: AssemblyStep, shown: Shown): ModelMarks {
  const { piece } = step;
  const sides: [MarkKind, CutSide][] = [
    ...step.turn.map((edge): [MarkKind, CutSide] => ['turn', { piece, edge }]),
    ...step.seams.flat().map(([edge]): [MarkKind, CutSide] => ['seam', { piece, edge }]),
    ...step.borders.map(([side]): [MarkKind, CutSide] => ['border', side]),
  ];
  return {
    edges: Int32Array.from(sides.flatMap(([, side]) => endsOf(shown, side))),
    kinds: sides.map(([kind]) => kind),
  };
}
