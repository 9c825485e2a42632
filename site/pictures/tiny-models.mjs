// Small models, each made to show one option. A mesh is `vertices` and `faces` of any number of corners.

/** The corners of a box and its six sides, counter-clockwise from outside; the top is the last one. */
function box([width, height, depth], [left, low, back] = [0, 0, 0]) {
  const at = (x, y, z) => [left + x * width, low + y * height, back + z * depth];
  return {
    vertices: [0, 1].flatMap((y) => [at(0, y, 0), at(1, y, 0), at(1, y, 1), at(0, y, 1)]),
    faces: [
      [0, 1, 2, 3],
      [0, 4, 5, 1],
      [1, 5, 6, 2],
      [2, 6, 7, 3],
      [3, 7, 4, 0],
      [7, 6, 5, 4],
    ],
  };
}

function together(...meshes) {
  let first = 0;
  const faces = meshes.flatMap((mesh) => {
    const moved = mesh.faces.map((face) => face.map((vertex) => vertex + first));
    first += mesh.vertices.length;
    return moved;
  });
  return { vertices: meshes.flatMap(({ vertices }) => vertices), faces };
}

/** A cylinder that stands; its axis is y. */
function drum(sides, radius, height) {
  const rim = (y) =>
    Array.from({ length: sides }, (_, i) => {
      const turn = (2 * Math.PI * i) / sides;
      return [radius * Math.cos(turn), y, radius * Math.sin(turn)];
    });
  const walls = Array.from({ length: sides }, (_, i) => {
    const next = (i + 1) % sides;
    return [i, sides + i, sides + next, next];
  });
  const bottom = walls.map(([i]) => i);
  const top = bottom.map((i) => sides + i).reverse();
  return { vertices: [...rim(0), ...rim(height)], faces: [bottom, top, ...walls] };
}

const withoutLid = ({ vertices, faces }) => ({ vertices, faces: faces.slice(0, -1) });

function obj({ vertices, faces }) {
  const points = vertices.map((point) => `v ${point.join(' ')}`);
  const polygons = faces.map((face) => `f ${face.map((vertex) => vertex + 1).join(' ')}`);
  return `${[...points, ...polygons].join('\n')}\n`;
}

const paints = ['0.85 0.3 0.2', '0.95 0.7 0.2', '0.3 0.6 0.4', '0.25 0.5 0.75', '0.6 0.4 0.65'];

/** A box whose sides have colours: the lid and the bottom the same. */
function paintedBox() {
  const { vertices, faces } = box([60, 40, 30]);
  const lines = faces.flatMap((face, i) => [
    `usemtl paint${i % paints.length}`,
    `f ${face.map((vertex) => vertex + 1).join(' ')}`,
  ]);
  const points = vertices.map((point) => `v ${point.join(' ')}`);
  const materials = paints.map((colour, i) => `newmtl paint${i}\nKd ${colour}\n`);
  return {
    'painted.obj': `${['mtllib painted.mtl', ...points, ...lines].join('\n')}\n`,
    'painted.mtl': materials.join(''),
  };
}

/** Files by their names, for each model by its own. */
export const tinyModels = {
  box: { 'box.obj': obj(box([60, 40, 30])) },
  'open box': { 'open-box.obj': obj(withoutLid(box([60, 40, 30]))) },
  'box in a box': {
    'nested.obj': obj(together(box([60, 40, 30]), box([30, 16, 12], [15, 12, 9]))),
  },
  'box with a bar': {
    'bar.obj': obj(together(box([60, 40, 30]), box([40, 12, 10], [40, 14, 10]))),
  },
  'box with a stud': {
    'stud.obj': obj(together(box([60, 40, 30]), box([4, 4, 4], [28, 40, 13]))),
  },
  drum: { 'drum.obj': obj(drum(20, 30, 30)) },
  painted: paintedBox(),
};
