import { BufferAttribute, Color, SRGBColorSpace, type BufferGeometry } from 'three';
import { partRgb } from '../model/part-colours.js';
import { partHatch } from './part-hatches.js';

/** Paper that belongs to no part yet. */
const blank = [242, 235, 220];

/** How much of its colour a part keeps beside those that stand out. */
const faded = 0.2;

function paintOf(part: number, share: number): Color {
  const colour = part < 0 ? blank : partRgb(part);
  const [red, green, blue] = colour.map(
    (value, i) => (share * value + (1 - share) * blank[i]!) / 255,
  );
  return new Color().setRGB(red!, green!, blue!, SRGBColorSpace);
}

/** Gives a geometry of faces with corners of their own room for colours and hatches. */
export function addPaint(geometry: BufferGeometry, faceCount: number): void {
  const attribute = (size: number): BufferAttribute =>
    new BufferAttribute(new Float32Array(3 * size * faceCount), size);
  geometry.setAttribute('color', attribute(3));
  geometry.setAttribute('hatch', attribute(1));
}

/**
 * Colours and hatches every face by its part; -1 is blank paper. Nothing else is rewritten.
 *
 * @param selected parts beside which all others fade, unless there are none
 */
export function paintFaces(
  geometry: BufferGeometry,
  labels: Int32Array,
  selected: ReadonlySet<number>,
): void {
  const colours = geometry.getAttribute('color') as BufferAttribute;
  const hatches = geometry.getAttribute('hatch') as BufferAttribute;
  const paints = new Map<number, Color>();
  labels.forEach((part, face) => {
    const share = selected.size === 0 || selected.has(part) ? 1 : faded;
    const paint = paints.get(part) ?? paintOf(part, share);
    paints.set(part, paint);
    for (let corner = 3 * face; corner < 3 * face + 3; ++corner) {
      colours.setXYZ(corner, paint.r, paint.g, paint.b);
      hatches.setX(corner, part < 0 ? 0 : partHatch(part));
    }
  });
  colours.needsUpdate = hatches.needsUpdate = true;
}
