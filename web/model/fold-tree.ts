import type { Piece } from './job.js';

/** How the faces of a piece hang on each other, from the face that stays. All indices are the piece's own. */
export interface FoldTree {
  /** Every face once, the root first, each after the one that it hangs on. */
  order: Int32Array;
  /** Per face: the face that it hangs on; -1 for the root. */
  parents: Int32Array;
  /** Per face: the edge that it hangs by; -1 for the root. */
  edges: Int32Array;
  /** Per face: its corner at which that edge begins as the face is walked; -1 for the root. */
  corners: Int32Array;
  /** Per face: how many edges it is away from the root. */
  depths: Int32Array;
}

/** A side of a face at an edge that is not cut. */
interface Side {
  face: number;
  corner: number;
  edge: number;
}

/** Per face: the sides of other faces that join it. */
function neighboursOf({ vertices, faces, edges, assignments }: Piece): Side[][] {
  const count = vertices.length / 2;
  const key = (a: number, b: number): number => Math.min(a, b) * count + Math.max(a, b);
  const edgeAt = new Map<number, number>();
  for (let edge = 0; edge < assignments.length; ++edge) {
    if (assignments[edge] !== 'B') edgeAt.set(key(edges[2 * edge]!, edges[2 * edge + 1]!), edge);
  }
  const first = new Map<number, Side>();
  const neighbours = Array.from({ length: faces.length / 3 }, (): Side[] => []);
  faces.forEach((from, at) => {
    const [face, corner] = [Math.floor(at / 3), at % 3];
    const edge = edgeAt.get(key(from, faces[3 * face + ((corner + 1) % 3)]!));
    if (edge === undefined) return;
    const other = first.get(edge);
    first.set(edge, { face, corner, edge });
    if (!other) return;
    neighbours[face]!.push(other);
    neighbours[other.face]!.push({ face, corner, edge });
  });
  return neighbours;
}

/**
 * Grows the tree breadth first over all edges that are not cut, from the root of the piece's motion,
 * or from its first face. Between flat faces there may be more edges than a tree needs: any will do.
 */
export function foldTree(piece: Piece): FoldTree {
  const count = piece.sources.length;
  const root = piece.motion?.root ?? 0;
  const neighbours = neighboursOf(piece);
  const [parents, edges, corners] = [0, 1, 2].map(() => new Int32Array(count).fill(-1));
  const depths = new Int32Array(count);
  const order = [root];
  const reached = new Set(order);
  for (const face of order) {
    for (const side of neighbours[face]!) {
      if (reached.has(side.face)) continue;
      reached.add(side.face);
      order.push(side.face);
      parents![side.face] = face;
      edges![side.face] = side.edge;
      corners![side.face] = side.corner;
      depths[side.face] = depths[face]! + 1;
    }
  }
  return {
    order: Int32Array.from(order),
    parents: parents!,
    edges: edges!,
    corners: corners!,
    depths,
  };
}
