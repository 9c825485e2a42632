import type { SheetPoint } from '../model/sheet-edges.js';

/** A place on a sheet that is on the page. */
export interface SheetPlace {
  /** Counted from 0. */
  sheet: number;
  point: SheetPoint;
  /** How many mm of the sheet one pixel of the page is. */
  mmPerPixel: number;
  /** How far it is below the upper end of the window, in pixels. */
  below: number;
}

/** Where on the picture of a sheet the pointer is. */
export function placeOn(
  svg: SVGSVGElement,
  sheet: number,
  { clientX, clientY }: MouseEvent,
): SheetPlace | null {
  const screen = svg.getScreenCTM();
  if (!screen) return null;
  const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(screen.inverse());
  const point = [x, svg.viewBox.baseVal.height - y] as const;
  return { sheet, point, mmPerPixel: 1 / screen.a, below: clientY };
}
