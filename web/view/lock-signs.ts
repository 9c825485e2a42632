import { putSigns, titled } from './sheet-signs.js';
import { shape } from './svg-shape.js';

/** A lock at an edge of a sheet; mm, y up, from the sheet's lower left. */
export interface LockSign {
  /** Whether the edge is always a fold, or always cut. */
  as: 'fold' | 'cut';
  /** Says so. */
  title: string;
  from: readonly [x: number, y: number];
  to: readonly [x: number, y: number];
}

/** Height in mm, and as a share of the edge, so that a sign hides no short one. */
const largest = 4;
const share = 0.5;

/** A padlock, 8 wide and 10 high around the middle; one that holds a fold is filled, one that holds a cut is empty. */
const body = 'M-4 -1h8v6h-8z';
const shackle = 'M-2.4 -1v-1.6a2.4 2.4 0 0 1 4.8 0v1.6';

function drawSign({ as, title: told, from, to }: LockSign, height: number): SVGElement {
  const [x1, y1, x2, y2] = [from[0], height - from[1], to[0], height - to[1]];
  const size = Math.min(largest, share * Math.hypot(x2 - x1, y2 - y1)) / 10;
  const place = `translate(${(x1 + x2) / 2} ${(y1 + y2) / 2}) scale(${size})`;
  const sign = shape('g', { transform: place, class: `lock-sign lock-sign--${as}` });
  sign.append(shape('path', { d: shackle, fill: 'none' }), shape('path', { d: body }));
  return titled(sign, told);
}

/** Puts the signs of locks on the picture of a sheet, in place of those before. */
export function signLocks(svg: SVGSVGElement, signs: readonly LockSign[]): void {
  const { height } = svg.viewBox.baseVal;
  putSigns(
    svg,
    'locks',
    signs.map((sign) => drawSign(sign, height)),
  );
}
