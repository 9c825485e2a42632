/** Draws a sample as a small SVG: parallel projection, flat shading, far faces first. */
import { add, dot, normalize, rotate, scale, triangleNormal } from './vector.mjs';

const SIZE = 160;
const MARGIN = 10;
const LIGHT = normalize([-0.45, 0.8, 0.55]);

/** Mixes a paper white towards a shade by how much light a face gets. */
function shade(light, [r, g, b]) {
  const lit = Math.max(0, Math.min(1, 0.5 + 0.5 * light));
  // The lightest shade keeps some of the colour: white faces would be lost on white paper.
  const channel = (dark) => Math.round(dark + 0.84 * (252 - dark) * lit ** 1.5);
  const hex = [r, g, b].map((c) => channel(c).toString(16).padStart(2, '0'));
  return `#${hex.join('')}`;
}

/**
 * @param mesh vertices and polygons
 * @param view Euler angles in degrees that turn the model towards the viewer, who looks along -z
 * @param ink darkest colour, [r, g, b]
 */
export function drawThumbnail({ vertices, faces }, view, ink) {
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
    .map((corners) => ({
      corners,
      normal: normalize(triangleNormal(...corners)),
      depth: corners.reduce((sum, p) => add(sum, scale(p, 1 / corners.length)), [0, 0, 0])[2],
    }))
    .filter(({ normal }) => normal[2] > 0)
    .sort((a, b) => a.depth - b.depth);
  const paths = visible.map(({ corners, normal }) => {
    const colour = shade(dot(normal, LIGHT), ink);
    return `<path fill="${colour}" stroke="${colour}" d="M${corners.map(place).join('L')}z"/>`;
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${SIZE} ${SIZE}"`,
    ` stroke-width=".6" stroke-linejoin="round">${paths.join('')}</svg>\n`,
  ].join('');
}
