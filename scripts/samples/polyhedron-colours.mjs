/**
 * Colours of the straight-edged models: names of materials, and a rule that gives each face its own; see `paint.mjs`.
 * Most rules go by the order in which `polyhedra.mjs` makes the faces.
 */

/** Faces that come in runs of the same length, each run of the next name in turn. */
const inTurn = (names, length) => (face) => names[Math.floor(face.index / length) % names.length];

/** Of a compound of five tetrahedra, whose 20 corners are the middles of an icosahedron's faces: no two neighbours are of one. */
const tetrahedra = [0, 1, 2, 3, 4, 4, 3, 2, 1, 3, 0, 1, 4, 4, 0, 2, 0, 2, 1, 3];

/** Nine bands of six rings, each ring of five sides in two triangles. */
const knotColours = {
  red: '#f0525f',
  orange: '#fb8d3c',
  amber: '#ffc13d',
  lime: '#a9d14b',
  green: '#45b97c',
  teal: '#35b8b5',
  blue: '#4a9be0',
  violet: '#8a78d8',
  rose: '#dd6fb1',
};
const knot = { colours: knotColours, of: inTurn(Object.keys(knotColours), 6 * 5 * 2) };

const starColours = {
  yellow: '#ffd23f',
  orange: '#fb923c',
  red: '#ef5d60',
  violet: '#9b7ede',
  blue: '#45a5e6',
};
/** Spikes of three faces. */
const star = {
  colours: starColours,
  of: ({ index }) => Object.keys(starColours)[tetrahedra[Math.floor(index / 3)]],
};

const house = {
  colours: {
    walls: '#fff0cf',
    gables: '#8cc6e7',
    roof: '#e2604a',
    eaves: '#a8714a',
    chimney: '#b5564a',
    floor: '#8fc066',
  },
  of: ({ normal, corners, centre: [, y] }) => {
    const isUpright = Math.abs(normal[1]) < 0.1;
    if (y === 0) return 'floor';
    if (corners.every((p) => p[0] <= 1 && p[1] <= 1.1)) return 'walls';
    if (isUpright && corners.every((p) => Math.abs(p[2]) < 1)) return 'chimney';
    if (normal[1] > 0.1) return y > 2.3 ? 'chimney' : 'roof';
    return isUpright && corners.every((p) => p[0] <= 1) ? 'gables' : 'eaves';
  },
};

/** A lifebelt: every segment has eight sides. */
const torus = {
  colours: { red: '#ee4f4a', white: '#fff8ec' },
  of: inTurn(['red', 'white'], 8),
};

const icosahedronColours = {
  mint: '#79d3b4',
  sky: '#6db7ee',
  lilac: '#b79be6',
  pink: '#f78fb0',
  sun: '#ffd257',
};
const icosahedron = {
  colours: icosahedronColours,
  of: ({ index }) => Object.keys(icosahedronColours)[tetrahedra[index]],
};

const cubeColours = {
  back: '#9b7ede',
  front: '#45a5e6',
  bottom: '#ef5d60',
  top: '#ffd23f',
  left: '#fb923c',
  right: '#58bd72',
};
const cube = { colours: cubeColours, of: inTurn(Object.keys(cubeColours), 1) };

export const polyhedronColours = { knot, star, house, torus, icosahedron, cube };
