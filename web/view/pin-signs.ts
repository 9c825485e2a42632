import { putSigns, titled } from './sheet-signs.js';
import { shape } from './svg-shape.js';

/** A pin in a piece that stays where it is; mm, y up, from the sheet's lower left. */
export interface PinSign {
  /** Says so. */
  title: string;
  at: readonly [x: number, y: number];
  /** How far the piece reaches around that place, at least. */
  room: number;
}

/** Radius in mm, and as a share of the room there is. */
const largest = 2.5;
const share = 0.8;

/** Of a picture of 10 around the middle: the needle below the head. */
const needle = 'M0 0v5';
const head = { cx: 0, cy: -1.5, r: 3 };

function drawSign({ title, at: [x, y], room }: PinSign, height: number): SVGElement {
  const size = Math.min(largest, share * room) / 5;
  const transform = `translate(${x} ${height - y}) scale(${size})`;
  const sign = shape('g', { transform, class: 'pin-sign' });
  sign.append(shape('path', { d: needle }), shape('circle', head));
  return titled(sign, title);
}

/** Puts the signs of pins on the picture of a sheet, in place of those before. */
export function signPins(svg: SVGSVGElement, signs: readonly PinSign[]): void {
  const { height } = svg.viewBox.baseVal;
  putSigns(
    svg,
    'pins',
    signs.map((sign) => drawSign(sign, height)),
  );
}
