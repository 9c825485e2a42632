import { shape } from './svg-shape.js';

/** What a mark points at: a fold to be turned, a seam to be closed, a border to be glued. */
export type MarkKind = 'turn' | 'seam' | 'border';

/** A line on a sheet that is pointed at; mm, y up, from the sheet's lower left. */
export interface SheetMark {
  kind: MarkKind;
  from: readonly [x: number, y: number];
  to: readonly [x: number, y: number];
  /** Stands at its middle. */
  label?: string;
}

/** Size of a label in mm, and as a share of its line, so that those of short edges keep apart. */
const [smallest, largest] = [1.5, 4];
const labelShare = 0.6;

function drawMark({ kind, from, to, label }: SheetMark, height: number): SVGElement[] {
  const [x1, y1, x2, y2] = [from[0], height - from[1], to[0], height - to[1]];
  const line = shape('line', { x1, y1, x2, y2, class: `mark mark--${kind}` });
  if (label === undefined) return [line];
  const [x, y] = [(x1 + x2) / 2, (y1 + y2) / 2];
  const size = Math.min(largest, Math.max(smallest, labelShare * Math.hypot(x2 - x1, y2 - y1)));
  const text = shape('text', { x, y, class: 'mark__label', 'font-size': size });
  text.textContent = label;
  return [line, text];
}

/** Marks lines on the picture of a sheet, in place of those that were marked before. */
export function markSheet(svg: SVGSVGElement, marks: readonly SheetMark[]): void {
  svg.querySelector('[data-marks]')?.remove();
  if (marks.length === 0) return;
  const { height } = svg.viewBox.baseVal;
  const group = shape('g', { 'data-marks': '' });
  group.append(...marks.flatMap((mark) => drawMark(mark, height)));
  svg.append(group);
}
