/** Draws a sample as a small SVG: parallel projection, flat shading, far faces first. */
import { add, dot, normalize, rotate, scale, triangleNormal } from './vector.mjs';

const SIZE = 160;
const MARGIN = 10;
const LIGHT = normalize([-0.45, 0.8, 0.55]);

/** A colour, `#rrggbb`, darkened or made a little paler by how much light falls on a face. */
function shade(light, colour) {
  const lit = Math.max(0, Math.min(1, 0.5 + 0.5 * light)) ** 1.5;
  const channel = (value) => Math.round(value * (0.76 + 0.24 * lit) + 0.16 * lit * (255 - value));
  const hex = [1, 3, 5].map((at) => channel(parseInt(colour.slice(at, at + 2), 16)).toString(16));
  return `#${hex.map((digits) => digits.padStart(2, '0')).join('')}`;
}

/**
 * @param mesh vertices and polygons
 * @param view Euler angles in degrees that turn the model towards the viewer, who looks along -z
 * @param colours of the faces, `#rrggbb`
 */
export function drawThumbnail({ vertices, faces }, view, colours) {
  const turned = vertices.map((p) => rotate(rotate(p, [0, view[1], 0]), [view[0], 0, view[2]]));
  const range = (axis) => {
    const values = turned.map((p) => p[axis]);
    return [Math.min(...values), Math.max(...values)];
  };
  const [[x0, x1], [y0, y1]] = [range(0), range(1)];
  const zoom = (SIZE - 2 * MARGIN) / Math.max(x1 - x0, y1 - y0);
  const place = ([x, y]) =>
    [SIZE / 2 + zoom * (x - (x0 + x1) / 2), SIZE / 2 - zoom * (y - (y0 + y1) / 2)]
      .map((value) => Number(value.toFixed(1)))
      .join(' ');
  const visible = faces
    .map((face) => face.map((v) => turned[v]))
    .map((corners, i) => ({
      corners,
      colour: colours[i],
      normal: normalize(triangleNormal(...corners)),
      depth: corners.reduce((sum, p) => add(sum, scale(p, 1 / corners.length)), [0, 0, 0])[2],
    }))
    .filter(({ normal }) => normal[2] > 0)
    .sort((a, b) => a.depth - b.depth);
  const paths = visible.map(({ corners, normal, colour }) => {
    const shown = shade(dot(normal, LIGHT), colour);
    return `<path fill="${shown}" stroke="${shown}" d="M${corners.map(place).join('L')}z"/>`;
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${SIZE} ${SIZE}"`,
    ` stroke-width=".6" stroke-linejoin="round">${paths.join('')}</svg>\n`,
  ].join('');
}
