import { putSigns, titled } from './sheet-signs.js';
import { shape } from './svg-shape.js';

/** A pin in a piece that stays where it is; mm, y up, from the sheet's lower left. */
export interface PinSign {
  /** Says so. */
  title: string;
  at: readonly [x: number, y: number];
}

/** Height in mm: smaller ones are not seen where a whole sheet is. */
const height = 6;

/** 10 high, with its tip at the place: the needle below the head. */
const needle = 'M0 -5v5';
const head = { cx: 0, cy: -7, r: 3 };

function drawSign({ title, at: [x, y] }: PinSign, sheetHeight: number): SVGElement {
  const transform = `translate(${x} ${sheetHeight - y}) scale(${height / 10})`;
  const sign = shape('g', { transform, class: 'pin-sign' });
  sign.append(shape('path', { d: needle }), shape('circle', head));
  return titled(sign, title);
}

/** Puts the signs of pins on the picture of a sheet, in place of those before. */
export function signPins(svg: SVGSVGElement, signs: readonly PinSign[]): void {
  const { height: sheetHeight } = svg.viewBox.baseVal;
  putSigns(
    svg,
    'pins',
    signs.map((sign) => drawSign(sign, sheetHeight)),
  );
}
