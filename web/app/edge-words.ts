import type { LockKind } from '../model/document-edits.js';
import type { EdgeAction, FlapPlace } from '../model/edge-edits.js';
import type { Piece } from '../model/job.js';
import { printedText, type SheetEdge, type SheetEdges } from '../model/sheet-edges.js';

function seamWords(edges: SheetEdges, edge: SheetEdge): string {
  const { pieces } = edges.result;
  const partner = edges.partnerOf(edge);
  const text = printedText(edge);
  const start = text === null ? `Edge of piece ${pieces[edge.piece]!.name}` : `Edge ${text}`;
  if (!partner) return `${start}: glued onto a face`;
  const place = partner.sheet === edge.sheet ? '' : ` on sheet ${partner.sheet + 1}`;
  if (partner.piece === edge.piece) {
    return `${start}: glued to another edge of piece ${pieces[edge.piece]!.name}`;
  }
  return `${start}: glued to ${printedText(partner) ?? `piece ${pieces[partner.piece]!.name}`}${place}`;
}

/** What an edge is, in one line. */
export function edgeWords(edges: SheetEdges, edge: SheetEdge): string {
  const { name } = edges.result.pieces[edge.piece]!;
  const { kind, angle } = edge;
  if (kind === 'cut' || edge.seam) return seamWords(edges, edge);
  if (kind === 'border') return `Edge of piece ${name}: the model ends here`;
  const fold = kind === 'mountain' ? 'Mountain fold' : 'Valley fold';
  return `${fold} of piece ${name}, ${Math.round(Math.abs(angle))}°`;
}

/** Where the flaps of a cut are, seen from the edge that is named before. */
export const flapWords: Readonly<Record<FlapPlace, string>> = {
  here: 'Its flap is on this side.',
  there: 'Its flap is on the other side.',
  both: 'It has flaps on both sides.',
  none: 'It has no flap.',
};

/** What is asked of an edge from now on. */
export const lockWords: Readonly<Record<LockKind, string>> = {
  fold: 'Locked: it is never cut.',
  cut: 'Locked: it is always cut.',
  free: '',
};

/** What hands the face at this side of a cut over to the piece at the other side. */
export function giftWords(edges: SheetEdges, edge: SheetEdge): string {
  const partner = edges.partnerOf(edge);
  return partner ? `Give this face to ${edges.result.pieces[partner.piece]!.name}` : '';
}

/** Which piece is shown, how large it is and where it lies. */
export function pieceWords({ name, width, height, sheet }: Piece): string {
  return `Piece ${name}, ${Math.round(width)} × ${Math.round(height)} mm, on sheet ${sheet + 1}`;
}

/** What came of an edit at an edge: the same edge in the result before and after. */
export interface EdgeOutcome {
  action: EdgeAction;
  before: { pieces: number; flap: FlapPlace };
  after: { pieces: number; flap: FlapPlace };
}

function piecesWords(before: number, after: number): string {
  if (before === after) return 'The piece opens at another place instead.';
  return `There are ${after} pieces now; before there were ${before}.`;
}

/** What came of an edit, where the edge alone does not tell it; empty if it does. */
export function outcomeWords({ action, before, after }: EdgeOutcome): string {
  switch (action) {
    case 'cut':
      return `Cut. ${piecesWords(before.pieces, after.pieces)}`;
    case 'join':
      return `Glued together. ${piecesWords(before.pieces, after.pieces)}`;
    case 'turn-flap':
      return after.flap === before.flap || after.flap === 'none'
        ? 'There is no room for a flap on that side.'
        : '';
    case 'both-flaps':
      return after.flap === 'both' ? '' : 'There is not enough room for two flaps.';
    case 'no-flap':
    case 'usual-flap':
      return '';
    case 'lock-fold':
    case 'lock-cut':
    case 'lock-free':
    case 'give-face':
      return after.pieces === before.pieces ? '' : piecesWords(before.pieces, after.pieces);
  }
}
