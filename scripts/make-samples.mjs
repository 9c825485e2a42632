/**
 * Makes the gallery of sample models: `web/app/public/samples/` gets one model with its materials and one thumbnail
 * for each, and `catalog.json`, which the page reads. The same script writes the same bytes.
 */
import { mkdir, rm, writeFile } from 'node:fs/promises';
import { animalColours } from './samples/animal-colours.mjs';
import { ANIMALS } from './samples/animals.mjs';
import { checkSolid } from './samples/check.mjs';
import { decimateHalf, mirrorHalf } from './samples/decimate.mjs';
import { paint } from './samples/paint.mjs';
import { polyhedronColours } from './samples/polyhedron-colours.mjs';
import { cube, house, icosahedron, knot, star, torus, triangulate } from './samples/polyhedra.mjs';
import { surfaceNets } from './samples/surface-nets.mjs';
import { drawThumbnail } from './samples/thumbnail.mjs';
import { toMtl, toObj } from './samples/write.mjs';

const OUT = new URL('../web/app/public/samples/', import.meta.url);

const LOOKS = { ...animalColours, ...polyhedronColours };

/** How each model is turned in its thumbnail, in degrees. */
const VIEWS = {
  whale: [12, -48, 0],
  duck: [16, -42, 0],
  cat: [8, -24, 0],
  rabbit: [12, -40, 0],
  fish: [12, -58, 0],
  heart: [10, -28, 0],
  knot: [-24, 18, 0],
  star: [14, 20, 0],
  house: [22, -38, 0],
  torus: [48, 12, 0],
  icosahedron: [12, 20, 0],
  cube: [26, -34, 0],
};

function organic({ solid, min, max, step, triangles }) {
  const fine = surfaceNets(solid, min, max, step);
  return mirrorHalf(decimateHalf(fine, triangles / 2));
}

/** Id, name, mesh and parts of every sample, in the gallery's order. */
function models() {
  return [
    ...ANIMALS.map((animal) => [animal.id, animal.name, organic(animal), animal.parts]),
    ['knot', 'Knot', triangulate(knot())],
    ['star', 'Star', star()],
    ['house', 'House', house()],
    ['torus', 'Ring', torus()],
    ['icosahedron', 'Icosahedron', icosahedron()],
    ['cube', 'Cube', cube()],
  ];
}

/** Writes the files of a model. @returns its entry in the catalogue */
async function writeSample(id, name, mesh, parts) {
  checkSolid(id, mesh);
  const [file, library, picture] = ['obj', 'mtl', 'svg'].map((ending) => `${id}.${ending}`);
  const { colours, ...rules } = LOOKS[id];
  const materials = paint(mesh, { colours, ...rules }, parts);
  const ofFaces = materials.map((material) => colours[material]);
  await writeFile(new URL(file, OUT), toObj(name, mesh, library, materials));
  await writeFile(new URL(library, OUT), toMtl(name, colours));
  await writeFile(new URL(picture, OUT), drawThumbnail(mesh, VIEWS[id], ofFaces));
  return { id, name, file, files: [file, library], picture, faces: mesh.faces.length };
}

async function main() {
  await rm(OUT, { recursive: true, force: true });
  await mkdir(OUT, { recursive: true });
  const catalog = [];
  for (const model of models()) catalog.push(await writeSample(...model));
  await writeFile(new URL('catalog.json', OUT), `${JSON.stringify(catalog, null, 2)}\n`);
}

await main();
