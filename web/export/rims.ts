/** Light rims, so that lines and letters are seen on pictures of any colour. */
import { isPictured, type GroundShape } from './ground-shape.js';
import type { Look } from './line-style.js';
import type { Point } from './point.js';
import type { PieceDrawing, SheetDrawing } from './sheet-drawing.js';

/** How far rims show beside lines: enough to see these, too little to mar the model; mm. */
const rim = 0.08;

/** Of the rims around letters, half of which the letters cover; mm. */
export const textRimWidth = 0.6;

export const rimColour = '#ffffff';

function rimsOf(width: number, walks: Point[][], closed: boolean): GroundShape[] {
  const style = { width: Math.round(1e4 * (width + 2 * rim)) / 1e4, colour: rimColour, dash: [] };
  return walks.length > 0 ? [{ kind: 'line', style, walks, closed }] : [];
}

/** A sheet whose lines have rims where they lie on pictures. */
export function withRims(sheet: SheetDrawing, { lines }: Look): SheetDrawing {
  const pieces = sheet.pieces.map((piece): PieceDrawing => {
    if (!isPictured(piece)) return piece;
    const rims = [
      ...rimsOf(lines.mountain.width, piece.mountains, false),
      ...rimsOf(lines.valley.width, piece.valleys, false),
      ...rimsOf(lines.cut.width, piece.cuts, true),
    ];
    return { ...piece, ground: [...piece.ground, ...rims] };
  });
  return { ...sheet, pieces };
}
