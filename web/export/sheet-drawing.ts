import type { JobResult, Piece } from '../model/job.js';
import { pieceLetter } from '../model/piece-letter.js';
import { placeLabel, type Label } from './label-place.js';
import type { Point, Segment } from './point.js';

/** The lines of one piece where they lie on the sheet; mm, y up, from the sheet's lower left. */
export interface PieceDrawing {
  letter: string;
  /** Closed boundary walks; slits are walked there and back. */
  cuts: Point[][];
  mountains: Segment[];
  valleys: Segment[];
  label: Label | null;
}

/** Everything that is drawn on one sheet, before a format gives it its syntax. */
export interface SheetDrawing {
  width: number;
  height: number;
  pieces: PieceDrawing[];
}

export interface DrawingOptions {
  /** Folds flatter than this many degrees are not drawn; default 3. */
  flatFold?: number;
}

function drawPiece(piece: Piece, flatFold: number): PieceDrawing {
  const point = (vertex: number): Point => [
    piece.x + piece.vertices[2 * vertex]!,
    piece.y + piece.vertices[2 * vertex + 1]!,
  ];
  const folds = (letter: string): Segment[] => {
    const segments: Segment[] = [];
    for (let edge = 0; edge < piece.assignments.length; ++edge) {
      if (piece.assignments[edge] !== letter) continue;
      if (Math.abs(piece.foldAngles[edge]!) < flatFold) continue;
      segments.push([point(piece.edges[2 * edge]!), point(piece.edges[2 * edge + 1]!)]);
    }
    return segments;
  };
  const letter = pieceLetter(piece.id);
  const label = placeLabel(piece, letter);
  return {
    letter,
    cuts: piece.outlines.map((outline) => Array.from(outline, point)),
    mountains: folds('M'),
    valleys: folds('V'),
    label: label && { ...label, x: label.x + piece.x, y: label.y + piece.y },
  };
}

/** The drawing of sheet number `sheet`, counted from 0. */
export function drawSheet(
  result: JobResult,
  sheet: number,
  { flatFold = 3 }: DrawingOptions = {},
): SheetDrawing {
  const { width, height } = result.sheets[sheet]!;
  const pieces = result.pieces.filter((piece) => piece.sheet === sheet);
  return { width, height, pieces: pieces.map((piece) => drawPiece(piece, flatFold)) };
}
