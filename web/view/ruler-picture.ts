import { rulerTicks } from './ruler.js';
import { shape } from './svg-shape.js';

/** Pixels: how broad a ruler is, and how long its lines are. */
const breadth = 20;
const lines = { main: 9, fine: 4 };

export interface Ruler {
  /** Where its 0 is, in pixels from its beginning. */
  zero: number;
  pixelsPerMm: number;
  /** Pixels. */
  length: number;
  isUpright: boolean;
}

/** Draws a ruler along the screen, in place of what was drawn before; its units are pixels. */
export function drawRuler(svg: SVGSVGElement, ruler: Ruler): void {
  const { zero, pixelsPerMm, length, isUpright } = ruler;
  const ticks = rulerTicks(zero, pixelsPerMm, length);
  const d = ticks
    .map(({ pixel, isMain }) => {
      const at = Math.round(pixel) + 0.5;
      const from = breadth - (isMain ? lines.main : lines.fine);
      return isUpright ? `M${from} ${at}H${breadth}` : `M${at} ${from}V${breadth}`;
    })
    .join('');
  const numbers = ticks
    .filter(({ isMain }) => isMain)
    .map(({ at, pixel }) => {
      const place = isUpright
        ? { transform: `translate(9 ${pixel - 3}) rotate(-90)` }
        : { transform: `translate(${pixel + 3} 9)` };
      const text = shape('text', place);
      text.textContent = String(at);
      return text;
    });
  svg.replaceChildren(shape('path', { d }), ...numbers);
}
