import { cutPairs, type CutSide } from './borders.js';
import { foldTree } from './fold-tree.js';
import type { Piece } from './job.js';
import { joinOrder } from './join-order.js';
import { defaultPrint } from './print-options.js';
import { seamsOf, type Seam } from './seams.js';

/** What a person does with one piece. */
export interface AssemblyStep {
  /** Index of the piece. */
  piece: number;
  /** How many folds there are, and into what all of them are creased at first. */
  folds: number;
  crease: 'mountain' | 'valley';
  /** Edges that are turned into the other kind after that: fewer than half. */
  turn: number[];
  /** What is closed after folding, in this order. */
  seams: Seam[];
  /** The pieces before it that it is glued to, ascending, and the edges along which it is. */
  partners: number[];
  borders: [CutSide, CutSide][];
}

/**
 * What a piece is folded along.
 *
 * Creasing all folds one way and turning the few others afterwards is easier than to look at every
 * one: Xi et al., section 5.2. What is not drawn on paper is not folded.
 *
 * @param flatFold folds flatter than this many degrees are not drawn
 */
export function creasesOf(
  { assignments, foldAngles }: Piece,
  flatFold = defaultPrint.flatFold,
): Pick<AssemblyStep, 'folds' | 'crease' | 'turn'> {
  const drawn = [...assignments].map((_, edge) => Math.abs(foldAngles[edge]!) >= flatFold);
  const edgesOf = (letter: string): number[] =>
    [...assignments].flatMap((kind, edge) => (kind === letter && drawn[edge] ? [edge] : []));
  const [mountains, valleys] = [edgesOf('M'), edgesOf('V')];
  const folds = mountains.length + valleys.length;
  return valleys.length > mountains.length
    ? { folds, crease: 'valley', turn: mountains }
    : { folds, crease: 'mountain', turn: valleys };
}

/**
 * The steps by which a person builds the model, one for each piece, in the order of `joinOrder`:
 * every piece is folded, closed from its middle outwards, and glued to those before it.
 *
 * @param flatFold folds flatter than this many degrees are not drawn
 */
export function assemblySteps(
  pieces: readonly Piece[],
  flatFold = defaultPrint.flatFold,
): AssemblyStep[] {
  const pairs = cutPairs(pieces);
  const done = new Set<number>();
  return joinOrder(pieces).map(({ piece, partners }) => {
    const borders = pairs.filter(([a, b]) =>
      a.piece === piece ? done.has(b.piece) : b.piece === piece && done.has(a.piece),
    );
    done.add(piece);
    const here = pieces[piece]!;
    return {
      piece,
      ...creasesOf(here, flatFold),
      seams: seamsOf(here, foldTree(here)),
      partners,
      borders,
    };
  });
}
