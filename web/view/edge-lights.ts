const svgNamespace = 'http://www.w3.org/2000/svg';

type Point = readonly [x: number, y: number];

/** An edge that is lit on a sheet; mm, y up, from the sheet's lower left. */
export interface EdgeLight {
  /** The edge that is meant, what it is glued to, the way between their middles, or where a hand takes its flap. */
  kind: 'own' | 'partner' | 'way' | 'grip';
  from: Point;
  to: Point;
}

/** How far an arc swings out, as a share of the way that it spans. */
const swing = 0.15;

function pathOf({ kind, from, to }: EdgeLight, height: number): string {
  const [x1, y1, x2, y2] = [from[0], height - from[1], to[0], height - to[1]];
  if (kind !== 'way') return `M${x1} ${y1}L${x2} ${y2}`;
  const x = (x1 + x2) / 2 - 2 * swing * (y2 - y1);
  const y = (y1 + y2) / 2 + 2 * swing * (x2 - x1);
  return `M${x1} ${y1}Q${x} ${y} ${x2} ${y2}`;
}

/** Lights edges on the picture of a sheet, in place of those that were lit before. */
export function lightEdges(svg: SVGSVGElement, lights: readonly EdgeLight[]): void {
  // Only its layers are looked through: a search in all that is drawn would take longer than a frame has time for.
  [...svg.children].find((child) => child.hasAttribute('data-lights'))?.remove();
  if (lights.length === 0) return;
  const { height } = svg.viewBox.baseVal;
  const group = document.createElementNS(svgNamespace, 'g');
  group.dataset['lights'] = '';
  for (const light of lights) {
    const path = document.createElementNS(svgNamespace, 'path');
    path.setAttribute('d', pathOf(light, height));
    path.setAttribute('class', `edge-light edge-light--${light.kind}`);
    group.append(path);
  }
  svg.append(group);
}
