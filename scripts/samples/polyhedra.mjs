/** The gallery's straight-edged models: vertices and outward polygons, written down or swept. */
import { sweep } from './sweep.mjs';
import { add, dot, length, normalize, scale, subtract, triangleNormal } from './vector.mjs';

const GOLDEN = (1 + Math.sqrt(5)) / 2;

export function cube() {
  const vertices = Array.from({ length: 8 }, (_, i) => [i & 1, (i >> 1) & 1, i >> 2]);
  const faces = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  return { vertices, faces };
}

export function icosahedron() {
  const vertices = [];
  for (const a of [-1, 1]) {
    for (const b of [-GOLDEN, GOLDEN]) vertices.push([0, a, b], [a, b, 0], [b, 0, a]);
  }
  return { vertices, faces: nearestTriples(vertices, 2) };
}

/** All outward triangles between vertices that are `side` apart, for a body around the origin. */
function nearestTriples(vertices, side) {
  const near = (a, b) => Math.abs(length(subtract(vertices[a], vertices[b])) - side) < 1e-9;
  const faces = [];
  for (let a = 0; a < vertices.length; a++) {
    for (let b = a + 1; b < vertices.length; b++) {
      if (!near(a, b)) continue;
      for (let c = b + 1; c < vertices.length; c++) {
        if (!near(a, c) || !near(b, c)) continue;
        const [pa, pb, pc] = [vertices[a], vertices[b], vertices[c]];
        const outward = dot(triangleNormal(pa, pb, pc), pa) > 0;
        faces.push(outward ? [a, b, c] : [a, c, b]);
      }
    }
  }
  return faces;
}

/** An icosahedron with a spike on each face. */
export function star() {
  const { vertices, faces } = icosahedron();
  const spikes = [];
  for (const [a, b, c] of faces) {
    const centre = scale(add(add(vertices[a], vertices[b]), vertices[c]), 1 / 3);
    const tip = vertices.push(scale(normalize(centre), 3.6)) - 1;
    spikes.push([a, b, tip], [b, c, tip], [c, a, tip]);
  }
  return { vertices, faces: spikes };
}

/** A cottage: walls, a gable roof with eaves, and a chimney that stands on the slope. */
export function house() {
  const outline = [
    [-1, 0],
    [1, 0],
    [1, 1.1],
    [1.3, 0.95],
    [1.3, 1.1],
    [0, 2],
    [-1.3, 1.1],
    [-1.3, 0.95],
    [-1, 1.1],
  ];
  const [front, back] = [1.4, -1.4];
  const vertices = [front, back].flatMap((z) => outline.map(([x, y]) => [x, y, z]));
  const n = outline.length;
  const faces = outline.map((_, i) => [i, n + i, n + ((i + 1) % n), (i + 1) % n]);
  // The gables are not convex, so they are cut into convex shares by hand.
  const gable = [
    [0, 1, 2, 8],
    [2, 3, 4],
    [6, 7, 8],
    [2, 4, 5],
    [5, 6, 8],
    [2, 5, 8],
  ];
  for (const share of gable) {
    faces.push(share);
    faces.push([...share].reverse().map((v) => v + n));
  }
  return addChimney({ vertices, faces }, [4, n + 4, n + 5, 5]);
}

/** Cuts a square hole into the roof slope [low front, low back, high back, high front]. */
function addChimney({ vertices, faces }, slope) {
  const [lowFront, lowBack, highBack, highFront] = slope.map((v) => vertices[v]);
  const at = (up, deep) =>
    add(
      scale(add(scale(lowFront, 1 - deep), scale(lowBack, deep)), 1 - up),
      scale(add(scale(highFront, 1 - deep), scale(highBack, deep)), up),
    );
  const places = [
    [0.42, 0.56],
    [0.42, 0.74],
    [0.78, 0.74],
    [0.78, 0.56],
  ];
  const foot = places.map(([up, deep]) => vertices.push(at(up, deep)) - 1);
  const top = foot.map((v) => vertices.push([vertices[v][0], 2.35, vertices[v][2]]) - 1);
  const kept = faces.filter((face) => !slope.every((v) => face.includes(v)));
  const ring = (inner, outer) =>
    inner.map((_, i) => {
      const j = (i + 1) % 4;
      return [outer[i], outer[j], inner[j], inner[i]];
    });
  const corners = places.map((_, i) => slope[i]);
  return { vertices, faces: [...kept, ...ring(foot, corners), ...ring(top, foot), top] };
}

/** A ring of `around` segments whose tube has `sides` sides. */
export function torus(around = 14, sides = 8, radius = 2, tube = 0.8) {
  const centre = (t) => [radius * Math.cos(t), 0, radius * Math.sin(t)];
  return sweep(centre, tube, around, sides, [0, 1, 0]);
}

/** A trefoil knot whose tube has five sides. */
export function knot() {
  const centre = (t) => [
    Math.sin(t) + 2 * Math.sin(2 * t),
    -Math.cos(t) + 2 * Math.cos(2 * t),
    -1.25 * Math.sin(3 * t),
  ];
  return sweep(centre, 0.62, 54, 5);
}

/** Cuts quads that need not be flat into triangles, along the shorter diagonal. */
export function triangulate({ vertices, faces }) {
  const gap = (a, b) => length(subtract(vertices[a], vertices[b]));
  return {
    vertices,
    faces: faces.flatMap((face) => {
      if (face.length !== 4) return [face];
      const [a, b, c, d] = face;
      return gap(a, c) <= gap(b, d)
        ? [
            [a, b, c],
            [a, c, d],
          ]
        : [
            [b, c, d],
            [b, d, a],
          ];
    }),
  };
}
