import type { DocumentEdit, FlapChoiceSide } from './document-edits.js';
import type { NamedSeam } from './job.js';
import type { SheetEdges } from './sheet-edges.js';

/** Where the flaps between a piece and others shall be: all on the piece, all on the others, nowhere, or as usual. */
export const pieceFlaps = ['here', 'there', 'none', 'usual'] as const;
export type PieceFlaps = (typeof pieceFlaps)[number];

/** As an edit names them: along a cut edge of a piece, the piece lies at the left. */
const sides: Readonly<Record<PieceFlaps, FlapChoiceSide>> = {
  here: 'first',
  there: 'second',
  none: 'none',
  usual: 'auto',
};

/** The edits that put all flaps of a piece, by its index, where they shall be: one for each of its seams. */
export function pieceFlapEdits(
  edges: SheetEdges,
  piece: number,
  where: PieceFlaps,
): DocumentEdit[] {
  const seen = new Set<NamedSeam>();
  return edges.all.flatMap((edge): DocumentEdit[] => {
    const { seam } = edge;
    if (edge.piece !== piece || !seam || seen.has(seam)) return [];
    seen.add(seam);
    const isWithin = edges.partnerOf(edge)?.piece === piece;
    // The piece has its flap anyway, and another piece cannot have it.
    if (isWithin && (where === 'here' || where === 'there')) return [];
    return [{ kind: 'flap', edge: edge.name, side: sides[where] }];
  });
}
