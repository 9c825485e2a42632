import type { PieceMotion } from '../model/piece-shape.js';

const svgNamespace = 'http://www.w3.org/2000/svg';

/** A piece on its way. */
export interface Ghost {
  /** Its outline, as it is drawn on the sheet where it lies: the path of an SVG in mm, y down. */
  outline: string;
  /** From where it lies to where it is, y up. */
  motion: PieceMotion;
  /** The pictures of the sheet where it lies and of that above which it is, which are as large. */
  sheet: SVGSVGElement;
  /** Whether it can be laid down there, or cannot, or is being laid down. */
  state: 'free' | 'refused' | 'waiting';
}

/** A motion of what is drawn with y down, on a sheet of this height in mm. */
function transformOf({ about, degrees, by }: PieceMotion, height: number): string {
  const [x, y] = [about[0], height - about[1]];
  return `translate(${by[0]} ${-by[1]}) rotate(${-degrees} ${x} ${y})`;
}

/**
 * Draws a piece on its way over all sheets, in place of what was drawn before; null: nothing.
 *
 * @param layer lies over the sheets and moves with them; its units are pixels
 */
export function drawGhost(layer: SVGSVGElement, ghost: Ghost | null): void {
  const screen = layer.getScreenCTM();
  const sheet = ghost?.sheet.getScreenCTM();
  if (!ghost || !screen || !sheet) {
    layer.replaceChildren();
    return;
  }
  const path =
    layer.querySelector('path') ??
    layer.appendChild(document.createElementNS(svgNamespace, 'path'));
  const { a, b, c, d, e, f } = screen.inverse().multiply(sheet);
  const place = transformOf(ghost.motion, ghost.sheet.viewBox.baseVal.height);
  if (path.getAttribute('d') !== ghost.outline) path.setAttribute('d', ghost.outline);
  path.setAttribute('transform', `matrix(${a} ${b} ${c} ${d} ${e} ${f}) ${place}`);
  path.setAttribute('class', `ghost ghost--${ghost.state}`);
}
