import type { ModelFile } from '../model/model-files.js';
import { concatenated, encode, linesOf, placeWord } from './ply-text.js';

/** Faces with any number of corners, in a row. */
export interface Polygons {
  /** 3 per vertex. */
  positions: readonly number[];
  /** Per face: where its corners begin; and their number at last. */
  firstCorners: readonly number[];
  /** Per corner: its vertex. */
  vertices: readonly number[];
  /** 2 per corner: its place in pictures, to the right and up; NaN for none. Null if no face has a picture. */
  places: readonly number[] | null;
  /** Per face: number of its material, -1 for none. */
  materials: readonly number[];
}

function headerOf({ positions, materials, places }: Polygons): string {
  const lines = [
    'ply',
    'format ascii 1.0',
    `element vertex ${positions.length / 3}`,
    ...[...'xyz'].map((name) => `property double ${name}`),
    `element face ${materials.length}`,
    'property list int int vertex_indices',
    ...(places ? ['property list int float texcoord'] : []),
    'property int material',
    'end_header',
  ];
  return `${lines.join('\n')}\n`;
}

/**
 * A file of polygons for the engine, which cuts them into triangles itself. Coordinates are written with all their
 * digits: how many there are tells the engine how precise they are.
 */
export function polygonFile(polygons: Polygons): ModelFile {
  const { positions, firstCorners, vertices, places, materials } = polygons;
  const listOf = (values: readonly (number | string)[]): string =>
    [values.length, ...values].join(' ');
  const faceLine = (face: number): string => {
    const [begin, end] = [firstCorners[face]!, firstCorners[face + 1]!];
    const words = [listOf(vertices.slice(begin, end))];
    if (places) words.push(listOf(places.slice(2 * begin, 2 * end).map(placeWord)));
    return [...words, materials[face]!].join(' ');
  };
  const bytes = concatenated([
    encode(headerOf(polygons)),
    ...linesOf(positions.length / 3, (i) => positions.slice(3 * i, 3 * i + 3).join(' ')),
    ...linesOf(materials.length, faceLine),
  ]);
  return { name: 'model.ply', bytes };
}
