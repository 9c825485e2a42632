import type { FoldTree } from '../model/fold-tree.js';
import { hingeOf } from '../model/folded-piece.js';
import type { Piece } from '../model/job.js';
import type { Vector } from '../model/vector.js';

/** Faces of a piece that no fold separates, and where they hang. */
export interface Panel {
  faces: number[];
  /** Index of the panel that this one hangs on; -1 for the root. */
  parent: number;
  /** The edge that it hangs by; -1 for the root. */
  edge: number;
  /** A point on that edge, and its direction as this panel is walked; on the sheet. */
  point: Vector;
  axis: Vector;
}

/** The panels of a piece, the root first, each after the one that it hangs on. */
export function panelsOf(piece: Piece, tree: FoldTree): Panel[] {
  const panels: Panel[] = [];
  const panelOf: number[] = [];
  for (const face of tree.order) {
    const [above, edge] = [tree.parents[face]!, tree.edges[face]!];
    if (above >= 0 && piece.assignments[edge] === 'F') {
      panelOf[face] = panelOf[above]!;
      panels[panelOf[face]]!.faces.push(face);
      continue;
    }
    const hinge =
      above < 0
        ? { parent: -1, point: [0, 0, 0] as const, axis: [0, 0, 1] as const }
        : { parent: panelOf[above]!, ...hingeOf(piece, tree, face) };
    panelOf[face] = panels.push({ faces: [face], edge, ...hinge }) - 1;
  }
  return panels;
}
