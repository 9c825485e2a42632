import { isCalibrated, rulerLength, type PrintOptions } from '../model/print-options.js';
import { bandHeight } from '../model/sheet-room.js';
import type { GroundShape } from './ground-shape.js';
import type { Point } from './point.js';
import type { SheetDrawing } from './sheet-drawing.js';
import type { TextLine } from './text-line.js';

/** What is known of a printer. */
export type Printer = Pick<PrintOptions, 'machine' | 'measured'>;

/** By how much lengths are drawn longer than they shall be on paper, across and up. */
export function corrections(options: Printer): [across: number, up: number] {
  if (!isCalibrated(options)) return [1, 1];
  const { measured } = options;
  return [rulerLength / measured[0], rulerLength / measured[1]];
}

/**
 * Draws a sheet for a printer that is out of scale, about the sheet's middle: what this printer makes
 * of it has the lengths of `drawing`. Texts are moved, but keep their size and their direction: a
 * few hundredths show nowhere.
 */
export function calibrated(
  drawing: SheetDrawing,
  [across, up]: readonly [number, number],
): SheetDrawing {
  if (across === 1 && up === 1) return drawing;
  const [x0, y0] = [drawing.width / 2, drawing.height / 2];
  const at = ([x, y]: Point): Point => [x0 + across * (x - x0), y0 + up * (y - y0)];
  const walk = (points: Point[]): Point[] => points.map(at);
  const line = ([from, to]: [Point, Point]): [Point, Point] => [at(from), at(to)];
  const shape = (one: GroundShape): GroundShape =>
    one.kind === 'image'
      ? { ...one, corners: line(one.corners) }
      : { ...one, walks: one.walks.map(walk) };
  const texts = (lines: TextLine[]): TextLine[] =>
    lines.map((text) => ({ ...text, at: at(text.at) }));
  return {
    ...drawing,
    pieces: drawing.pieces.map((piece) => ({
      ...piece,
      cuts: piece.cuts.map(walk),
      flaps: piece.flaps.map(walk),
      mountains: piece.mountains.map(line),
      valleys: piece.valleys.map(line),
      guides: piece.guides.map(line),
      ground: piece.ground.map(shape),
      texts: texts(piece.texts),
    })),
    frame: {
      strokes: drawing.frame.strokes.map((stroke) => ({
        ...stroke,
        points: walk(stroke.points),
      })),
      texts: texts(drawing.frame.texts),
    },
  };
}

/** What goes over the edge of a sheet with a correction, before it is corrected: mm from the edge. */
export function lostBorder(
  { width, height }: Pick<SheetDrawing, 'width' | 'height'>,
  printer: Printer,
): number {
  const [across, up] = corrections(printer);
  return Math.max(0, (width / 2) * (1 - 1 / across), (height / 2) * (1 - 1 / up));
}

/** The least margin, in whole mm, with which rulers and title stay on a sheet that is corrected. */
export function marginFor(sheet: Pick<SheetDrawing, 'width' | 'height'>, printer: Printer): number {
  return Math.ceil(lostBorder(sheet, printer) + bandHeight);
}

/** By how many mm something is drawn beyond the edge of its sheet; 0 if nothing is. */
export function overrun({ width, height, pieces, frame }: SheetDrawing): number {
  const points = [
    ...pieces.flatMap(({ cuts }) => cuts.flat()),
    ...frame.strokes.flatMap(({ points }) => points),
  ];
  return points.reduce((most, [x, y]) => Math.max(most, -x, -y, x - width, y - height), 0);
}
