/** Says which material each face of a sample is made of, by the rules that its colours come with. */
import { add, length, normalize, scale, subtract, triangleNormal } from './vector.mjs';

/**
 * What a rule may know of a face. Left and right are not told apart, so colours of symmetric models are symmetric.
 *
 * @typedef {object} Face
 * @property {number} index
 * @property {number[][]} corners with positive x: a rule that all of them must fulfil has a border without teeth
 * @property {number[]} centre mean of its corners
 * @property {number[]} normal outward, of length 1, as seen on the side of positive x
 * @property {string | undefined} part the part of an implicit solid in which its centre lies deepest
 * @property {(name: string) => number} distance of its centre from a part, about; negative inside
 */

function deepest(parts, point) {
  const depths = Object.entries(parts).map(([name, solid]) => [solid(point), name]);
  return depths.sort(([a], [b]) => a - b)[0]?.[1];
}

/** @returns {Face} */
function describe(corners, index, parts) {
  const sum = corners.reduce(add);
  const side = sum[0] < 0 ? -1 : 1;
  const onOneSide = ([x, y, z]) => [side * x, y, z];
  const centre = onOneSide(scale(sum, 1 / corners.length));
  return {
    index,
    corners: corners.map(onOneSide),
    centre,
    normal: onOneSide(normalize(triangleNormal(...corners))),
    part: deepest(parts, centre),
    distance: (name) => parts[name](centre),
  };
}

/** The faces nearest to a point: one, or one on each side. */
function nearest(faces, point) {
  const gaps = faces.map(({ centre }) => length(subtract(centre, point)));
  const least = Math.min(...gaps);
  return faces.filter((_, i) => gaps[i] < least + 1e-9);
}

/**
 * The name of a material for each face.
 *
 * @param mesh vertices and polygons
 * @param look rule `of` from a face to the name of its material, and points in `spots` whose nearest faces differ
 * @param parts solids of an implicit model by their names
 * @throws {Error} for a material without a colour, and for a colour that no face has
 */
export function paint({ vertices, faces }, { colours, of, spots = {} }, parts = {}) {
  const described = faces.map((face, index) =>
    describe(
      face.map((v) => vertices[v]),
      index,
      parts,
    ),
  );
  const names = described.map(of);
  for (const [name, points] of Object.entries(spots)) {
    for (const face of points.flatMap((point) => nearest(described, point)))
      names[face.index] = name;
  }
  const [known, used] = [Object.keys(colours), new Set(names)];
  const unknown = [...used].filter((name) => !known.includes(name));
  const idle = known.filter((name) => !used.has(name));
  if (unknown.length + idle.length > 0)
    throw new Error(`no colour for: ${unknown.join(', ')}; no face in: ${idle.join(', ')}`);
  return names;
}
