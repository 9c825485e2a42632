import { shape } from './svg-shape.js';

/** Puts signs on the picture of a sheet, in place of those of their kind before. */
export function putSigns(svg: SVGSVGElement, kind: 'locks' | 'pins', signs: SVGElement[]): void {
  const name = `data-${kind}`;
  [...svg.children].find((child) => child.hasAttribute(name))?.remove();
  if (signs.length === 0) return;
  const group = shape('g', { [name]: '' });
  group.append(...signs);
  svg.append(group);
}

/** What a sign says to those who point at it, or hear it. */
export function titled(sign: SVGElement, told: string): SVGElement {
  const title = shape('title', {});
  title.textContent = told;
  sign.prepend(title);
  return sign;
}
