/** Crosses at the same places of both sides of a sheet: held up to the light, they show whether the sides fit. */
import { bandHeight, bandOf } from '../model/sheet-room.js';
import { bandLines, type Stroke } from './sheet-frame.js';
import type { Point } from './point.js';
import type { SheetDrawing } from './sheet-drawing.js';

/** Of a cross, across and up: in the band it stays 0.75 mm away from pieces; mm. */
const crossSize = 4;

/** What they take of the ends of both bands; mm. */
export const crossRoom = crossSize + bandLines.gap;

function crossAt([x, y]: Point): Stroke[] {
  const half = crossSize / 2;
  const line = (...points: Point[]): Stroke => ({ points, closed: false });
  return [line([x - half, y], [x + half, y]), line([x, y - half], [x, y + half])];
}

/** One at the upper end of the band at the left, one at the right end of that below: far from each other. */
export function alignmentCrosses(
  { width, height }: Pick<SheetDrawing, 'width' | 'height'>,
  margin: number,
  inset: number,
): Stroke[] {
  const middle = bandOf(margin, inset).from + bandHeight / 2;
  const inner = margin + crossSize / 2;
  return [...crossAt([middle, height - inner]), ...crossAt([width - inner, middle])];
}
