import type { EdgeName, JobResult, NamedSeam } from './job.js';
import { modelVertices } from './model-vertices.js';
import { dot, minus, vectorAt, type Vector } from './vector.js';

/** mm from the lower left of a sheet, y up. */
export type SheetPoint = readonly [x: number, y: number];

/** An edge of a piece that can be pointed at: all but those inside of flat panels, which nobody sees. */
export interface SheetEdge {
  /** A fold, one of the two sides of a cut, or an edge at which the model itself ends. */
  kind: 'mountain' | 'valley' | 'cut' | 'border';
  /** Index of the piece, and of the edge in it. */
  piece: number;
  edge: number;
  sheet: number;
  from: SheetPoint;
  to: SheetPoint;
  /** Its vertices of the model, as the piece walks them: a cut has the piece on its left, seen from outside. */
  name: EdgeName;
  modelEdge: number;
  /** Of a fold, degrees: valley positive, mountain negative. */
  angle: number;
  /** What is glued there; null for folds, and where the model ends. */
  seam: NamedSeam | null;
}

/**
 * How near to an edge a point must be, as a share of the edge's length: this leaves more than half of the way to
 * the middle of an even triangle to those who point at its inside.
 */
const reachShare = 1 / 8;

function lengthOf({ from, to }: SheetEdge): number {
  return Math.hypot(to[0] - from[0], to[1] - from[1]);
}

function distance([x, y]: SheetPoint, { from, to }: SheetEdge): number {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const along = ((x - from[0]) * dx + (y - from[1]) * dy) / (dx * dx + dy * dy || 1);
  const share = Math.min(1, Math.max(0, along));
  return Math.hypot(from[0] + share * dx - x, from[1] + share * dy - y);
}

/** How many sides each edge of the model has among the cut edges of all pieces. */
function countSides({ pieces }: JobResult): Map<number, number> {
  const sides = new Map<number, number>();
  for (const { assignments, modelEdges } of pieces) {
    modelEdges.forEach((modelEdge, edge) => {
      if (assignments[edge] === 'B') sides.set(modelEdge, (sides.get(modelEdge) ?? 0) + 1);
    });
  }
  return sides;
}

/** The edges of all pieces, piece by piece; about a millisecond for a thousand. */
function edgesOf(result: JobResult): SheetEdge[] {
  const sides = countSides(result);
  const seams = new Map(result.seams.flatMap((seam) => [...seam.modelEdges].map((e) => [e, seam])));
  const kinds: Readonly<Record<string, SheetEdge['kind']>> = { M: 'mountain', V: 'valley' };
  return result.pieces.flatMap((piece, index) => {
    const { edges, vertices, assignments, sheet, x, y } = piece;
    const names = modelVertices(piece, result.model);
    const point = (vertex: number): SheetPoint => [
      x + vertices[2 * vertex]!,
      y + vertices[2 * vertex + 1]!,
    ];
    return [...assignments].flatMap((letter, edge): SheetEdge[] => {
      if (letter === 'F') return [];
      const [a, b] = [edges[2 * edge]!, edges[2 * edge + 1]!];
      const modelEdge = piece.modelEdges[edge]!;
      const angle = piece.foldAngles[edge]!;
      const kind = kinds[letter] ?? (sides.get(modelEdge) === 2 ? 'cut' : 'border');
      const seam = kind === 'cut' || kind === 'border' ? (seams.get(modelEdge) ?? null) : null;
      const ends = { from: point(a), to: point(b), name: [names[a]!, names[b]!] as const };
      return [{ kind, piece: index, edge, sheet, ...ends, modelEdge, angle, seam }];
    });
  });
}

/** What is printed at an edge to tell what it is glued to: `C3`, or `46`; null without a seam. */
export function printedText({ seam, piece }: SheetEdge): string | null {
  return seam?.texts[piece === seam.pieces[0] ? 0 : 1] ?? null;
}

/** The edges on the sheets of a result that can be pointed at. Each question looks at all of them: some thousands. */
export class SheetEdges {
  readonly all: readonly SheetEdge[];

  constructor(readonly result: JobResult) {
    this.all = edgesOf(result);
  }

  /**
   * The edge that is nearest to a point; null if none is within reach.
   *
   * @param reach of long edges, in mm; that of short ones is smaller
   * @param least of any edge, in mm
   */
  nearest(sheet: number, point: SheetPoint, reach: number, least = 0): SheetEdge | null {
    let best: SheetEdge | null = null;
    let bestDistance = Infinity;
    for (const edge of this.all) {
      if (edge.sheet !== sheet) continue;
      const away = distance(point, edge);
      if (away < bestDistance) [best, bestDistance] = [edge, away];
    }
    if (!best) return null;
    const own = Math.max(least, Math.min(reach, reachShare * lengthOf(best)));
    return bestDistance <= own ? best : null;
  }

  /** The other side of a cut; null for all other edges. */
  partnerOf(edge: SheetEdge): SheetEdge | null {
    if (edge.kind !== 'cut') return null;
    const isOther = (one: SheetEdge): boolean => one.modelEdge === edge.modelEdge && one !== edge;
    return this.all.find(isOther) ?? null;
  }

  /** An edge by its vertices of the model; of a cut the side that has them in this order. */
  find([v, w]: EdgeName): SheetEdge | null {
    const named = (from: number, to: number): SheetEdge | undefined =>
      this.all.find(({ name }) => name[0] === from && name[1] === to);
    return named(v, w) ?? named(w, v) ?? null;
  }

  /** Of each side of a seam that has this text printed (`C3`, `46`) or this name in lists (`A-C:3`), one edge. */
  numbered(text: string): SheetEdge[] {
    const wanted = text.trim().toLowerCase();
    const found = this.all.filter((edge) =>
      [printedText(edge), edge.seam?.name].some((one) => one?.toLowerCase() === wanted),
    );
    return found.filter((edge, at) => found.findIndex((one) => this.isSameSide(one, edge)) === at);
  }

  /** The edges on this side of a seam: several in a straight line have one number. */
  side(edge: SheetEdge): SheetEdge[] {
    return edge.seam ? this.all.filter((other) => this.isSameSide(edge, other)) : [edge];
  }

  /** Whether there is a flap on this side of a seam. */
  hasFlap(edge: SheetEdge): boolean {
    const { edges } = this.result.pieces[edge.piece]!.flaps;
    return this.side(edge).some((one) => edges.includes(one.edge));
  }

  /** A seam is straight in the model, and its two sides walk it in opposite directions. */
  private isSameSide(a: SheetEdge, b: SheetEdge): boolean {
    if (a.piece !== b.piece || a.seam !== b.seam) return false;
    return dot(this.wayOf(a), this.wayOf(b)) > 0;
  }

  private wayOf({ name: [v, w] }: SheetEdge): Vector {
    const { vertices } = this.result.model;
    return minus(vectorAt(vertices, w), vectorAt(vertices, v));
  }
}
