import { hatchPaths, hatchTile, hatchWidth } from './part-hatches.js';
import { shape } from './svg-shape.js';

/** Sheets on the screen. */

/** Side of a hatch's tile in mm. */
const tile = 3;

/** How a piece is painted. */
export interface PiecePaint {
  /** CSS colour. */
  colour: string;
  /** Index of the hatch. */
  hatch: number;
}

/** The hatch as a pattern with a name that no other sheet on the page has. */
function hatchPattern(id: string, hatch: number): SVGElement {
  const pattern = shape('pattern', {
    id,
    width: tile,
    height: tile,
    viewBox: `0 0 ${hatchTile} ${hatchTile}`,
    patternUnits: 'userSpaceOnUse',
  });
  const lines = { d: hatchPaths[hatch] ?? '', fill: 'none', stroke: '#232a31' };
  pattern.append(shape('path', { ...lines, 'stroke-width': hatchWidth, opacity: 0.55 }));
  return pattern;
}

/** What is clicked of a piece that is printed in colours; a style may veil it. */
function veil(d: string, letter: string): SVGElement {
  return shape('path', {
    d,
    fill: '#ffffff',
    'fill-opacity': 0,
    class: 'veil',
    'data-area': letter,
  });
}

/**
 * Paints each piece below all lines, along its own cut line: its colour, and over it its hatch,
 * which a style may hide. On sheets that are printed in colours it paints nothing.
 */
function paintPieces(svg: SVGSVGElement, paints: ReadonlyMap<string, PiecePaint>): void {
  const ground = shape('g', {});
  const printed = svg.querySelector('#texture');
  for (const cut of svg.querySelectorAll<SVGPathElement>('#cut > [data-piece]')) {
    const letter = cut.dataset['piece'] ?? '';
    const paint = paints.get(letter);
    if (!paint) continue;
    const d = cut.getAttribute('d') ?? '';
    if (printed) {
      ground.append(veil(d, letter));
      continue;
    }
    // Names may hold what an address must not.
    const id = `hatch-${letter.replace(/[^A-Za-z0-9]/g, (sign) => `_${sign.charCodeAt(0)}`)}`;
    ground.append(
      shape('path', { d, fill: paint.colour, 'data-area': letter }),
      hatchPattern(id, paint.hatch),
      shape('path', { d, fill: `url(#${id})`, class: 'hatch' }),
    );
  }
  if (printed) printed.after(ground);
  else svg.prepend(ground);
}

/**
 * The picture of one sheet, from the SVG that is written for it.
 *
 * @param source SVG of the sheet, as exported
 * @param paints how each piece is painted, by its letter
 * @param description what a screen reader says
 */
export function sheetPicture(
  source: string,
  paints: ReadonlyMap<string, PiecePaint>,
  description: string,
): SVGSVGElement {
  const parsed = new DOMParser().parseFromString(source, 'image/svg+xml').documentElement;
  const svg = document.importNode(parsed, true);
  if (!(svg instanceof SVGSVGElement)) throw new Error('A sheet is not an SVG document');
  // Several sheets share one page, where an id must be unique.
  for (const group of svg.querySelectorAll('[id]')) {
    group.setAttribute('data-layer', group.id);
  }
  paintPieces(svg, paints);
  for (const group of svg.querySelectorAll('[data-layer]')) group.removeAttribute('id');
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', description);
  return svg;
}
