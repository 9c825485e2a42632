// A model in the colours of its parts as SVG: parallel projection, flat shading, far faces first.
import { dot, normalize, rotate, triangleNormal } from '../../scripts/samples/vector.mjs';

const light = normalize([-0.45, 0.8, 0.55]);

/** Room around it, and decimals of coordinates, in units of the picture, which is 320 of them wide. */
const [size, margin] = [320, 8];
const short = (value) => Number(value.toFixed(1));

/** The box of points as they are seen. */
function boxOf(points) {
  const range = (axis) => {
    const values = points.map((point) => point[axis]);
    return [Math.min(...values), Math.max(...values)];
  };
  return { x: range(0), y: range(1) };
}

/** How strongly a face is lit, as a share of black to lay over its colour; both sides of paper are seen. */
const shadow = (normal) => short(0.42 * (1 - Math.abs(dot(normal, light))) * 100) / 100;

/**
 * @param {number[][][]} triangles three points each, with y up
 * @param {string[]} colours one for each triangle
 * @param {[number, number]} view turns in degrees about x and about y
 */
export function paintedModel(triangles, colours, [aboutX, aboutY]) {
  const seen = triangles.map((corners) =>
    corners.map((point) => rotate(rotate(point, [0, aboutY, 0]), [aboutX, 0, 0])),
  );
  const { x, y } = boxOf(seen.flat());
  const zoom = (size - 2 * margin) / (x[1] - x[0]);
  const height = short(zoom * (y[1] - y[0]) + 2 * margin);
  const place = (point) =>
    `${short(margin + zoom * (point[0] - x[0]))} ${short(margin + zoom * (y[1] - point[1]))}`;
  const depth = (corners) => corners[0][2] + corners[1][2] + corners[2][2];
  const order = seen.map((_, i) => i).sort((a, b) => depth(seen[a]) - depth(seen[b]));
  const paths = order.map((i) => {
    const d = `M${seen[i].map(place).join('L')}z`;
    const dark = shadow(normalize(triangleNormal(...seen[i])));
    return `<path d="${d}" fill="${colours[i]}"/><path d="${d}" fill-opacity="${dark}" stroke="none"/>`;
  });
  const shape = `stroke="#232a31" stroke-opacity=".35" stroke-width=".6" stroke-linejoin="round"`;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size} ${height}" width="${size}" height="${height}" ${shape}>${paths.join('')}</svg>\n`;
}
