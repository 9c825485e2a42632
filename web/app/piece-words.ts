import type { Laying } from '../model/piece-edits.js';
import type { PlaceFault, SheetPieces } from '../model/sheet-pieces.js';
import { placeOf, type PiecePlace } from '../model/piece-shape.js';
import { count } from '../words/numbers.js';

/** What a piece is, in one line; `place`: where it is now, if it is on its way. */
export function pieceWords(pieces: SheetPieces, piece: number, place?: PiecePlace): string {
  const own = pieces.result.pieces[piece]!;
  const at = place ?? placeOf(own);
  const [width, height] = pieces.sizeAt(piece, at).map(Math.round);
  const faces = count(own.sources.length, 'face');
  return `Piece ${own.name}: ${width} × ${height} mm, sheet ${at.sheet + 1}, ${faces}`;
}

/** Why a piece cannot lie at a place. */
function faultWords(pieces: SheetPieces, fault: PlaceFault): string {
  if (fault.what === 'outside')
    return 'it would be too near to the edge of the sheet to be printed';
  return `it would lie on ${pieces.result.pieces[fault.piece]!.name}`;
}

/** That a piece cannot stay where it is. */
export function cannotStay(pieces: SheetPieces, piece: number, fault: PlaceFault): string {
  const { name } = pieces.result.pieces[piece]!;
  return `${name} cannot stay here: ${faultWords(pieces, fault)}.`;
}

/** That a piece is where it was, as it cannot lie where it was dropped. */
export function notDropped(pieces: SheetPieces, piece: number, fault: PlaceFault): string {
  const { name } = pieces.result.pieces[piece]!;
  return `${name} is back where it was. There, ${faultWords(pieces, fault)}.`;
}

/** That there is no room for a piece on a sheet, from 0. */
export function noRoom(pieces: SheetPieces, piece: number, sheet: number): string {
  const { name } = pieces.result.pieces[piece]!;
  return `There is no room for ${name} on sheet ${sheet + 1}. Move another piece away first.`;
}

/** What was done with a piece. */
export function layingWords(laying: Laying, name: string): string {
  if (laying === 'kept') return `${name} stays here now, whatever else moves.`;
  return laying === 'moved' ? `Moved ${name}.` : `Turned ${name}.`;
}
