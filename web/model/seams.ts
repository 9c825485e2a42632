import { cutPairs } from './borders.js';
import type { FoldTree } from './fold-tree.js';
import { Groups } from './groups.js';
import type { Piece } from './job.js';

/** Two edges of a piece that become one. */
export type ClosedPair = readonly [edge: number, edge: number];

/** Pairs that are closed one after the other, like a zip. */
export type Seam = ClosedPair[];

/** A pair with what its turn depends on. */
interface Candidate {
  pair: ClosedPair;
  /** The two vertices at either end that will meet. */
  ends: [number, number][];
  /** How far from the root it is, in folds. */
  depth: number;
}

/** The face beside each cut edge. */
function faceBeside({ vertices, faces }: Piece): (from: number, to: number) => number {
  const count = vertices.length / 2;
  const beside = new Map<number, number>();
  faces.forEach((from, at) => {
    const face = Math.floor(at / 3);
    beside.set(from * count + faces[3 * face + ((at + 1) % 3)]!, face);
  });
  return (from, to) => beside.get(from * count + to) ?? beside.get(to * count + from)!;
}

function candidatesOf(piece: Piece, tree: FoldTree): Candidate[] {
  const beside = faceBeside(piece);
  return cutPairs([piece]).map(([{ edge: a }, { edge: b }]) => {
    // Each side walks along its own face, and so against the other side.
    const [from, to] = [piece.edges[2 * a]!, piece.edges[2 * a + 1]!];
    const [start, end] = [piece.edges[2 * b]!, piece.edges[2 * b + 1]!];
    return {
      pair: [a, b],
      ends: [
        [from, end],
        [to, start],
      ],
      depth: tree.depths[beside(from, to)]! + tree.depths[beside(start, end)]!,
    };
  });
}

/** A piece on its way to being closed: which pairs are left, and which of them have begun to meet. */
class Closing {
  private readonly left: Set<Candidate>;
  private readonly begun: Set<Candidate>;
  /** Vertices that have met. */
  private readonly met: Groups;
  /** The pairs around the vertices that will meet in one place, by any of these. */
  private readonly around: (vertex: number) => readonly Candidate[];

  constructor(candidates: readonly Candidate[], vertices: number) {
    this.met = new Groups(vertices);
    this.left = new Set(candidates);
    this.begun = new Set(candidates.filter((candidate) => this.hasBegun(candidate)));
    const places = new Groups(vertices);
    for (const { ends } of candidates) for (const [a, b] of ends) places.unite(a, b);
    const byPlace = new Map<number, Candidate[]>();
    for (const candidate of candidates) {
      for (const [vertex] of candidate.ends) {
        const place = places.of(vertex);
        byPlace.set(place, [...(byPlace.get(place) ?? []), candidate]);
      }
    }
    this.around = (vertex) => byPlace.get(places.of(vertex)) ?? [];
  }

  /** Closes the next seam; null when there is none. */
  next(): Seam | null {
    if (this.left.size === 0) return null;
    const seam: Seam = [];
    const open = this.begun.size > 0 ? this.begun : this.left;
    let pair: Candidate | undefined = [...open].reduce((best, one) =>
      one.depth < best.depth ? one : best,
    );
    while (pair) {
      seam.push(pair.pair);
      const woken: Candidate[] = this.close(pair);
      pair = woken.length === 1 ? woken[0] : undefined;
    }
    return seam;
  }

  private hasBegun({ ends }: Candidate): boolean {
    return ends.some(([a, b]) => this.met.together(a, b));
  }

  /** Closes a pair; the pairs that begin to meet by that. */
  private close(pair: Candidate): Candidate[] {
    this.left.delete(pair);
    this.begun.delete(pair);
    for (const [a, b] of pair.ends) this.met.unite(a, b);
    const woken = new Set(
      pair.ends
        .flatMap(([vertex]) => this.around(vertex))
        .filter((one) => this.left.has(one) && !this.begun.has(one) && this.hasBegun(one)),
    );
    for (const one of woken) this.begun.add(one);
    return [...woken];
  }
}

/**
 * The order in which a folded piece is closed: every seam begins where its edges already meet, as
 * near to the root as there is one, and is closed like a zip until it forks or ends. Seams that
 * begin nowhere, as that of a tube, begin at their edge nearest to the root.
 */
export function seamsOf(piece: Piece, tree: FoldTree): Seam[] {
  const closing = new Closing(candidatesOf(piece, tree), piece.vertices.length / 2);
  const seams: Seam[] = [];
  for (let seam = closing.next(); seam; seam = closing.next()) seams.push(seam);
  return seams;
}
