import type { EdgeAction, FlapPlace } from '../model/edge-edits.js';
import type { Piece } from '../model/job.js';
import { printedText, type SheetEdge, type SheetEdges } from '../model/sheet-edges.js';
import type { Words } from '../words/words.js';

function nameOf(edges: SheetEdges, edge: SheetEdge): { number: string | null; piece: string } {
  return { number: printedText(edge), piece: edges.result.pieces[edge.piece]!.name };
}

function seamWords({ edges: told }: Words, edges: SheetEdges, edge: SheetEdge): string {
  const partner = edges.partnerOf(edge);
  const own = nameOf(edges, edge);
  if (!partner) return told.ontoFace(own);
  if (partner.piece === edge.piece) return told.withinPiece(own);
  const sheet = partner.sheet === edge.sheet ? null : partner.sheet + 1;
  return told.toPiece(own, nameOf(edges, partner), sheet);
}

/** What an edge is, in one line. */
export function edgeWords(words: Words, edges: SheetEdges, edge: SheetEdge): string {
  const { name } = edges.result.pieces[edge.piece]!;
  const { kind, angle } = edge;
  if (kind === 'cut' || edge.seam) return seamWords(words, edges, edge);
  if (kind === 'border') return words.edges.border(name);
  return words.edges.fold(kind, name, Math.round(Math.abs(angle)));
}

/** What hands the face at this side of a cut over to the piece at the other side. */
export function giftWords({ edges: told }: Words, edges: SheetEdges, edge: SheetEdge): string {
  const partner = edges.partnerOf(edge);
  return partner ? told.gift(edges.result.pieces[partner.piece]!.name) : '';
}

/** Which piece is shown, how large it is and where it lies. */
export function pieceWords({ pieces }: Words, { name, width, height, sheet }: Piece): string {
  const [across, up] = [Math.round(width), Math.round(height)];
  return pieces.inPlace({ name, width: across, height: up, sheet: sheet + 1 });
}

/** What an edit can change at an edge; `height`: of its flap, mm, 0 without one. */
export interface EdgeState {
  pieces: number;
  flap: FlapPlace;
  height: number;
}

/** Flaps that are lower than asked for by less than this, mm, are as asked for. */
const shrinkage = 0.05;

/** What came of an edit at an edge: the same edge in the result before and after. */
export interface EdgeOutcome {
  /** A height that was asked for is in mm. */
  action: EdgeAction | { height: number };
  before: EdgeState;
  after: EdgeState;
}

function piecesWords({ edges }: Words, before: number, after: number): string {
  return before === after ? edges.opensElsewhere : edges.pieces(after, before);
}

/** What came of an edit, where the edge alone does not tell it; empty if it does. */
export function outcomeWords(words: Words, { action, before, after }: EdgeOutcome): string {
  const { edges } = words;
  if (typeof action === 'object') {
    return after.height < action.height - shrinkage ? edges.roomForFlap(after.height) : '';
  }
  const pieces = piecesWords(words, before.pieces, after.pieces);
  switch (action) {
    case 'cut':
      return edges.cut(pieces);
    case 'join':
      return edges.joined(pieces);
    case 'turn-flap':
      return after.flap === before.flap || after.flap === 'none' ? edges.noRoomForFlap : '';
    case 'both-flaps':
      return after.flap === 'both' ? '' : edges.noRoomForFlaps;
    case 'no-flap':
    case 'usual-flap':
      return '';
    case 'lock-fold':
    case 'lock-cut':
    case 'lock-free':
    case 'give-face':
      return after.pieces === before.pieces ? '' : pieces;
  }
}
