/** Sheets on the screen. */

const svgNamespace = 'http://www.w3.org/2000/svg';

/** Paints each piece below all lines, along its own cut line. */
function paintPieces(svg: SVGSVGElement, colours: ReadonlyMap<string, string>): void {
  const ground = document.createElementNS(svgNamespace, 'g');
  for (const cut of svg.querySelectorAll<SVGPathElement>('#cut > [data-piece]')) {
    const letter = cut.dataset['piece'] ?? '';
    const area = document.createElementNS(svgNamespace, 'path');
    area.setAttribute('d', cut.getAttribute('d') ?? '');
    area.setAttribute('fill', colours.get(letter) ?? 'none');
    area.dataset['area'] = letter;
    ground.append(area);
  }
  svg.prepend(ground);
}

/**
 * The picture of one sheet, from the SVG that is written for it.
 *
 * @param source SVG of the sheet, as exported
 * @param colours CSS colour of each piece, by its letter
 * @param description what a screen reader says
 */
export function sheetPicture(
  source: string,
  colours: ReadonlyMap<string, string>,
  description: string,
): SVGSVGElement {
  const parsed = new DOMParser().parseFromString(source, 'image/svg+xml').documentElement;
  const svg = document.importNode(parsed, true);
  if (!(svg instanceof SVGSVGElement)) throw new Error('A sheet is not an SVG document');
  paintPieces(svg, colours);
  // Several sheets share one page, where an id must be unique.
  for (const group of svg.querySelectorAll('[id]')) {
    group.setAttribute('data-layer', group.id);
    group.removeAttribute('id');
  }
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', description);
  return svg;
}
