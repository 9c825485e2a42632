/** What is said in English of edges, pieces and parts of a result, and of changes of them. */
import type { LockKind } from '../../model/document-edits.js';
import type { FlapPlace } from '../../model/edge-edits.js';
import type { Laying } from '../../model/piece-edits.js';
import { all, count, figure, parts } from './numbers.js';

/** An edge by the number at it; null: it has none. */
export interface EdgeName {
  number: string | null;
  /** Name of the piece. */
  piece: string;
}

const edge = ({ number, piece }: EdgeName): string =>
  number === null ? `Edge of piece ${piece}` : `Edge ${number}`;

export const edges = {
  ontoFace: (own: EdgeName): string => `${edge(own)}: glued onto a face`,
  withinPiece: (own: EdgeName): string =>
    `${edge(own)}: glued to another edge of piece ${own.piece}`,
  /** `sheet`: of the other edge, if it is another one. */
  toPiece: (own: EdgeName, other: EdgeName, sheet: number | null): string =>
    `${edge(own)}: glued to ${other.number ?? `piece ${other.piece}`}` +
    (sheet === null ? '' : ` on sheet ${figure(sheet)}`),
  border: (piece: string): string => `Edge of piece ${piece}: the model ends here`,
  fold: (kind: 'mountain' | 'valley', piece: string, degrees: number): string =>
    `${kind === 'mountain' ? 'Mountain fold' : 'Valley fold'} of piece ${piece}, ${figure(degrees)}°`,
  /** Where the flaps of a cut are, seen from the edge that is named before. */
  flaps: {
    here: 'Its flap is on this side.',
    there: 'Its flap is on the other side.',
    both: 'It has flaps on both sides.',
    none: 'It has no flap.',
  } satisfies Record<FlapPlace, string>,
  /** What is asked of an edge from now on. */
  locks: {
    fold: 'Locked: it is never cut.',
    cut: 'Locked: it is always cut.',
    free: '',
  } satisfies Record<LockKind, string>,
  lockSigns: { fold: 'Never cut', cut: 'Always cut' },
  gift: (piece: string): string => `Give this face to ${piece}`,
  opensElsewhere: 'The piece opens at another place instead.',
  pieces: (after: number, before: number): string =>
    `There are ${figure(after)} pieces now; before there were ${figure(before)}.`,
  cut: (pieces: string): string => `Cut. ${pieces}`,
  joined: (pieces: string): string => `Glued together. ${pieces}`,
  noRoomForFlap: 'There is no room for a flap on that side.',
  noRoomForFlaps: 'There is not enough room for two flaps.',
  /** mm. */
  roomForFlap: (height: number): string =>
    `There is room for ${figure(height)} mm here, not for more.`,
  notFound: (text: string): string => `No edge and no piece is called ${text}.`,
  /** Which of several places it is. */
  place: (title: string, number: number, of: number): string =>
    `${title}: ${figure(number)} of ${figure(of)}`,
  show: 'Show',
  showWhat: (title: string): string => `Show: ${title}`,
};

export const pieces = {
  /** `sheet`: from 1. */
  inPlace: (p: { name: string; width: number; height: number; sheet: number }): string =>
    `Piece ${p.name}, ${figure(p.width)} × ${figure(p.height)} mm, on sheet ${figure(p.sheet)}`,
  full: (p: {
    name: string;
    width: number;
    height: number;
    sheet: number;
    faces: number;
  }): string =>
    `Piece ${p.name}: ${figure(p.width)} × ${figure(p.height)} mm, sheet ${figure(p.sheet)}, ${count(p.faces, 'face')}`,
  /** Why a piece cannot lie at a place: it would lie on another one, or, if that is null, beyond the edge. */
  cannotStay: (name: string, other: string | null): string =>
    other === null
      ? `${name} cannot stay here: it would be too near to the edge of the sheet to be printed.`
      : `${name} cannot stay here: it would lie on ${other}.`,
  notDropped: (name: string, other: string | null): string =>
    other === null
      ? `${name} is back where it was. There, it would be too near to the edge of the sheet to be printed.`
      : `${name} is back where it was. There, it would lie on ${other}.`,
  noRoom: (name: string, sheet: number): string =>
    `There is no room for ${name} on sheet ${figure(sheet)}. Move another piece away first.`,
  laid: {
    kept: (name: string): string => `${name} stays here now, whatever else moves.`,
    moved: (name: string): string => `Moved ${name}.`,
    turned: (name: string): string => `Turned ${name}.`,
  } satisfies Record<Laying, unknown>,
  mayMove: (name: string): string => `${name} may move again.`,
  staysHere: 'It stays here.',
  letMove: 'Let it move',
  keepHere: 'Keep it here',
  newSheet: 'a new one',
};

export const partWords = {
  split: (parts: number): string => (parts > 1 ? 'Split these parts' : 'Split this part'),
  merge: (parts: number): string =>
    parts > 2 ? `Merge these ${figure(parts)}` : 'Merge these two',
  part: (part: number): string => `Part ${figure(part)}`,
  nameOf: (part: number): string => `Name of part ${figure(part)}`,
  name: 'name',
  noNet: 'no net',
  pieces: (names: readonly string[]): string =>
    `${names.length === 1 ? 'piece' : 'pieces'} ${all(names)}`,
  faces: (faces: number): string => count(faces, 'face'),
};

/** Names of changes, to be read after "Undo: ". */
export const changes = {
  undo: (change: string | null): string => (change === null ? 'Undo' : `Undo: ${change}`),
  redo: (change: string | null): string => (change === null ? 'Redo' : `Redo: ${change}`),
  split: (numbers: readonly number[]): string => `split of ${parts(numbers)}`,
  merge: (numbers: readonly number[]): string => `merging of ${parts(numbers)}`,
  assign: (numbers: readonly number[]): string => `faces given to ${parts(numbers)}`,
  again: (numbers: readonly number[]): string => `another net for ${parts(numbers)}`,
  name: (numbers: readonly number[]): string => `name of ${parts(numbers)}`,
  /** `piece`: the name of the one that has the edge; null if it is not known any more. */
  cut: (piece: string | null): string => (piece === null ? 'cut' : `cut in ${piece}`),
  join: (piece: string | null): string => (piece === null ? 'fold made' : `fold made in ${piece}`),
  /** `edge`: its number; null if it has none. */
  flap: {
    first: (edge: string | null): string => `flap of ${edge ?? 'an edge'} turned`,
    second: (edge: string | null): string => `flap of ${edge ?? 'an edge'} turned`,
    both: (edge: string | null): string => `flaps on both sides of ${edge ?? 'an edge'}`,
    none: (edge: string | null): string => `flap of ${edge ?? 'an edge'} taken away`,
    auto: (edge: string | null): string => `flap of ${edge ?? 'an edge'} as usual`,
  },
  flapHeight: (edge: string | null, height: number): string =>
    `flap of ${edge ?? 'an edge'} ${figure(height)} mm high`,
  pieceFlaps: (piece: string | null): string => `flaps of ${piece ?? 'a piece'}`,
  lock: (as: LockKind, edge: string | null, piece: string | null): string => {
    const kind = { fold: 'never cut', cut: 'always cut', free: 'lock taken away' }[as];
    if (edge !== null) return `${kind} at ${edge}`;
    return piece === null ? kind : `${kind} in ${piece}`;
  },
  paper: {
    size: 'change of size',
    strips: 'change of strips of paper',
    numbers: 'change of edge numbers',
    paper: 'change of paper',
  },
  look: 'change of look',
  unpin: (piece: string | null): string => `let ${piece ?? 'a piece'} move`,
  place: {
    kept: (piece: string | null): string => `kept ${piece ?? 'a piece'} in place`,
    moved: (piece: string | null): string => `moved ${piece ?? 'a piece'}`,
    turned: (piece: string | null): string => `turned ${piece ?? 'a piece'}`,
  } satisfies Record<Laying, unknown>,
};
