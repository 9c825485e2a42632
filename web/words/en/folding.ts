/** What is said in English of folding and of the steps in which a model is built. */
import { all, count, figure } from './numbers.js';

export const folding = {
  flat: 'flat',
  foldedBy: (percent: number): string => `folded by ${figure(percent)} %`,
  folded: 'folded',
  whole: 'the model',
  inPlace: (piece: string): string => `piece ${piece} is in place`,
  joining: (piece: string): string => `joining piece ${piece}`,
  /** `names`: of the pieces for which no way is known; null: none of them has one. */
  doubts: (names: readonly string[] | null): string =>
    `No way to fold ${names === null ? 'these pieces' : all(names)} is known: ` +
    'all folds are shown turning evenly, and faces may pass through each other.',
  play: 'Play',
  pause: 'Pause',
};

export const steps = {
  done: (done: number, of: number): string => `${figure(done)} of ${figure(of)} done`,
  pieceDone: (piece: string): string => `Piece ${piece} is done`,
  piece: (piece: string): string => `Piece ${piece}:`,
  /** `turn`: how many of the folds are of the other kind; the sheets show which. */
  crease: (p: { folds: number; crease: 'mountain' | 'valley'; turn: number }): string => {
    if (p.folds === 0) return 'it has no folds.';
    const other = p.crease === 'mountain' ? 'valley' : 'mountain';
    if (p.turn === 0) {
      return p.folds === 1
        ? `crease its only fold as a ${p.crease}.`
        : `crease its ${figure(p.folds)} folds as ${p.crease}s.`;
    }
    const turned =
      p.turn === 1 ? `this one into a ${other}` : `these ${figure(p.turn)} into ${other}s`;
    return `crease its ${figure(p.folds)} folds as ${p.crease}s, then turn ${turned}.`;
  },
  close: (seams: number): string =>
    seams === 1
      ? 'Close its seam.'
      : `Close its ${figure(seams)} seams in the order of their numbers.`,
  glue: (names: readonly string[], edges: number): string =>
    `Glue it to ${all(names)} along ${count(edges, 'edge')}.`,
};
