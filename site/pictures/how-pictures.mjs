// Pictures of how it works, of one real run: what was learned, the parts, a net in search, the generations, the folding.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateSync } from 'node:zlib';
import { fromSources } from './from-sources.mjs';
import { paintedModel } from './painted-model.mjs';

const entry = `
  export { partColour } from './web/model/part-colours.js';
  export { pngAround } from './web/model/png-file.js';
  export { foldTree } from './web/model/fold-tree.js';
  export { foldedVertices } from './web/model/folded-piece.js';
`;

/** The model of all these pictures, and its run. */
export const shownModel = 'whale';
export const shownOptions = { parts: 6, seed: 1 };

/** So that the whale shows its side, and the table its depth. */
const [ofModel, ofTable] = [
  [20, -52],
  [-58, 0],
];

/** A matrix as a picture in grey, 255 being black, as the studio has it. */
function matrixPng({ size, values }, { pngAround }) {
  const rows = Buffer.alloc(size * (3 * size + 1));
  values.forEach((value, i) => {
    const at = Math.floor(i / size) * (3 * size + 1) + 1 + 3 * (i % size);
    rows.fill(255 - value, at, at + 3);
  });
  return pngAround({ width: size, height: size, channels: 3 }, deflateSync(rows));
}

const point = (vertices, at) => [vertices[3 * at], vertices[3 * at + 1], vertices[3 * at + 2]];

function trianglesOf({ vertices, faces }) {
  return Array.from({ length: faces.length / 3 }, (_, face) =>
    [0, 1, 2].map((corner) => point(vertices, faces[3 * face + corner])),
  );
}

/** A net while it is searched, with overlaps in red. */
function netSvg({ corners, overlapping }, colour) {
  const xs = corners.filter((_, i) => i % 2 === 0);
  const ys = corners.filter((_, i) => i % 2 === 1);
  const [left, high] = [Math.min(...xs), Math.max(...ys)];
  const zoom = 300 / (Math.max(...xs) - left);
  const height = Math.ceil(zoom * (high - Math.min(...ys)) + 10);
  const place = (at) =>
    `${(5 + zoom * (corners[at] - left)).toFixed(1)} ${(5 + zoom * (high - corners[at + 1])).toFixed(1)}`;
  const faces = Array.from(overlapping, (isOver, face) => {
    const [fill, alpha] = isOver ? ['#d6141e', 0.72] : [colour, 1];
    const d = [0, 2, 4].map((corner) => place(6 * face + corner)).join('L');
    return `<path d="M${d}z" fill="${fill}" fill-opacity="${alpha}"/>`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 310 ${height}" width="310" height="${height}" stroke="#232a31" stroke-width=".5">${faces.join('')}</svg>\n`;
}

/** All pieces on their table at a time of their folding; the sheets lie side by side. */
function foldedSvg(result, time, { foldTree, foldedVertices, partColour }) {
  const shown = result.pieces.map((piece) => {
    const vertices = foldedVertices(piece, foldTree(piece), time);
    const moved = vertices.map(
      (value, i) => value + [piece.x + 230 * piece.sheet, piece.y, 0][i % 3],
    );
    return { triangles: trianglesOf({ vertices: moved, faces: piece.faces }), part: piece.part };
  });
  const triangles = shown.flatMap((piece) => piece.triangles);
  const colours = shown.flatMap((piece) => piece.triangles.map(() => partColour(piece.part)));
  return paintedModel(triangles, colours, ofTable);
}

/** What a whole body looks like as one net: at first, and at last. */
async function searchedNets(runs) {
  const events = [];
  const options = { parts: 1, seed: 1, compact: 'off', folding: 'off' };
  const session = await runs.session(shownModel, options, (event) => events.push(event));
  const shown = events.filter(({ type, net }) => type === 'generation' && net);
  return { nets: [shown[0], shown.at(-1)], moves: (await session.result()).search.moves };
}

/** Draws all of them into a folder. @returns figures that texts may name */
export async function howPictures(runs, folder) {
  const sources = await fromSources(entry);
  const events = [];
  const session = await runs.session(shownModel, shownOptions, (event) => events.push(event));
  const result = await session.result();
  const write = (name, contents) => writeFileSync(join(folder, name), contents);

  const learned = events.filter(({ type, matrix }) => type === 'learned' && matrix);
  write('matrix-first.png', matrixPng(learned[0].matrix, sources));
  write('matrix-last.png', matrixPng(learned.at(-1).matrix, sources));
  const colours = Array.from(result.labels, (part) => sources.partColour(part));
  write('parts.svg', paintedModel(trianglesOf(result.model), colours, ofModel));
  const { nets, moves } = await searchedNets(runs);
  nets.forEach(({ net, part }, i) => write(`net-${i}.svg`, netSvg(net, sources.partColour(part))));
  [0, 0.35, 0.7, 1].forEach((time, i) => write(`fold-${i}.svg`, foldedSvg(result, time, sources)));
  return {
    runs: learned.map(({ runs: count }) => count),
    faces: result.labels.length,
    parts: result.parts,
    pieces: result.pieces.length,
    moves,
    overlaps: nets.map(({ overlaps }) => overlaps),
  };
}
