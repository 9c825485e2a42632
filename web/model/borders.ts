import type { Piece } from './job.js';

/** One side of a cut: an edge of a piece. */
export interface CutSide {
  piece: number;
  edge: number;
}

/** Length of an edge of a piece in mm. */
export function edgeLength({ vertices, edges }: Piece, edge: number): number {
  const [a, b] = [edges[2 * edge]!, edges[2 * edge + 1]!];
  return Math.hypot(
    vertices[2 * b]! - vertices[2 * a]!,
    vertices[2 * b + 1]! - vertices[2 * a + 1]!,
  );
}

/** What is glued to what: the two sides of every cut. Edges at the border of the model have no other side. */
export function cutPairs(pieces: readonly Piece[]): [CutSide, CutSide][] {
  const open = new Map<number, CutSide>();
  const pairs: [CutSide, CutSide][] = [];
  pieces.forEach(({ assignments, modelEdges }, piece) => {
    for (let edge = 0; edge < assignments.length; ++edge) {
      if (assignments[edge] !== 'B') continue;
      const other = open.get(modelEdges[edge]!);
      if (other) pairs.push([other, { piece, edge }]);
      else open.set(modelEdges[edge]!, { piece, edge });
    }
  });
  return pairs;
}
