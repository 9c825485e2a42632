import type { PlaceFault, SheetPieces } from '../model/sheet-pieces.js';
import { placeOf, type PiecePlace } from '../model/piece-shape.js';
import type { Words } from '../words/words.js';

/** What a piece is, in one line; `place`: where it is now, if it is on its way. */
export function pieceWords(
  words: Words,
  pieces: SheetPieces,
  piece: number,
  place?: PiecePlace,
): string {
  const own = pieces.result.pieces[piece]!;
  const at = place ?? placeOf(own);
  const [width, height] = pieces.sizeAt(piece, at).map(Math.round) as [number, number];
  return words.pieces.full({
    name: own.name,
    width,
    height,
    sheet: at.sheet + 1,
    faces: own.sources.length,
  });
}

/** Name of the piece that is in the way; null if it is the edge of the sheet. */
function otherOf({ result }: SheetPieces, fault: PlaceFault): string | null {
  return fault.what === 'outside' ? null : result.pieces[fault.piece]!.name;
}

/** That a piece cannot stay where it is. */
export function cannotStay(
  words: Words,
  pieces: SheetPieces,
  piece: number,
  fault: PlaceFault,
): string {
  const { name } = pieces.result.pieces[piece]!;
  return words.pieces.cannotStay(name, otherOf(pieces, fault));
}

/** That a piece is where it was, as it cannot lie where it was dropped. */
export function notDropped(
  words: Words,
  pieces: SheetPieces,
  piece: number,
  fault: PlaceFault,
): string {
  const { name } = pieces.result.pieces[piece]!;
  return words.pieces.notDropped(name, otherOf(pieces, fault));
}
