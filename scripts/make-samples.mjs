/**
 * Makes the gallery of sample models: `web/app/public/samples/` gets one file and one thumbnail
 * per model and `catalog.json`, which the page reads. The same script writes the same bytes.
 */
import { mkdir, rm, writeFile } from 'node:fs/promises';
import { ANIMALS } from './samples/animals.mjs';
import { checkSolid } from './samples/check.mjs';
import { decimateHalf, mirrorHalf } from './samples/decimate.mjs';
import { cube, house, icosahedron, knot, star, torus, triangulate } from './samples/polyhedra.mjs';
import { surfaceNets } from './samples/surface-nets.mjs';
import { drawThumbnail } from './samples/thumbnail.mjs';
import { toObj, toStl } from './samples/write.mjs';

const OUT = new URL('../web/app/public/samples/', import.meta.url);

/** How each model is turned in its thumbnail, in degrees, and its darkest shade. */
const LOOKS = {
  whale: [
    [20, -52, 0],
    [28, 74, 110],
  ],
  duck: [
    [16, -42, 0],
    [150, 96, 20],
  ],
  cat: [
    [8, -24, 0],
    [122, 58, 34],
  ],
  rabbit: [
    [12, -40, 0],
    [92, 70, 96],
  ],
  fish: [
    [12, -58, 0],
    [24, 98, 92],
  ],
  heart: [
    [10, -28, 0],
    [140, 26, 40],
  ],
  knot: [
    [-24, 18, 0],
    [40, 60, 120],
  ],
  star: [
    [14, 20, 0],
    [150, 104, 16],
  ],
  house: [
    [22, -38, 0],
    [120, 52, 36],
  ],
  torus: [
    [48, 12, 0],
    [30, 92, 72],
  ],
  icosahedron: [
    [12, 20, 0],
    [70, 62, 120],
  ],
  cube: [
    [26, -34, 0],
    [70, 78, 88],
  ],
};

function organic({ solid, min, max, step, triangles }) {
  const fine = surfaceNets(solid, min, max, step);
  return mirrorHalf(decimateHalf(fine, triangles / 2));
}

/** Id, name, mesh and file format of every sample, in the gallery's order. */
function models() {
  return [
    ...ANIMALS.map((animal) => [animal.id, animal.name, organic(animal), 'obj']),
    ['knot', 'Knot', triangulate(knot()), 'obj'],
    ['star', 'Star', star(), 'stl'],
    ['house', 'House', house(), 'obj'],
    ['torus', 'Ring', torus(), 'obj'],
    ['icosahedron', 'Icosahedron', icosahedron(), 'stl'],
    ['cube', 'Cube', cube(), 'obj'],
  ];
}

async function main() {
  await rm(OUT, { recursive: true, force: true });
  await mkdir(OUT, { recursive: true });
  const catalog = [];
  for (const [id, name, mesh, format] of models()) {
    checkSolid(id, mesh);
    const file = `${id}.${format}`;
    const [view, ink] = LOOKS[id];
    await writeFile(new URL(file, OUT), format === 'stl' ? toStl(mesh) : toObj(name, mesh));
    await writeFile(new URL(`${id}.svg`, OUT), drawThumbnail(mesh, view, ink));
    catalog.push({ id, name, file, picture: `${id}.svg`, faces: mesh.faces.length });
  }
  await writeFile(new URL('catalog.json', OUT), `${JSON.stringify(catalog, null, 2)}\n`);
}

await main();
