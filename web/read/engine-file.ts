/** Writes triangles so that the engine reads them with the precision that they have, and with how they look. */
import type { ModelFile } from '../model/model-files.js';
import { concatenated, encode, linesOf, placeWord } from './ply-text.js';
import { bitsOfSingle, halfSpacing, largestOf } from './precision.js';
import type { PartLooks, Soup } from './soup.js';

/** What a PLY file is made of. */
interface Surface extends PartLooks {
  /** 3 per vertex. */
  positions: Float64Array;
  /** 3 per triangle. */
  corners: Int32Array;
}

function surfaceOf(soup: Soup): Surface {
  return { positions: soup.positions(), corners: soup.corners(), ...soup.looks() };
}

function headerOf(format: string, coordinate: string, surface: Surface): string {
  const { positions, corners, places, colours, materials } = surface;
  const properties = (type: string, names: string): string[] =>
    [...names].map((name) => `property ${type} ${name}`);
  const lines = [
    'ply',
    `format ${format} 1.0`,
    `element vertex ${positions.length / 3}`,
    ...properties(coordinate, 'xyz'),
    ...(places ? properties('float', 'st') : []),
    ...(colours ? ['red', 'green', 'blue'].map((name) => `property uchar ${name}`) : []),
    `element face ${corners.length / 3}`,
    'property list uchar int vertex_indices',
    ...(materials ? ['property int material'] : []),
    'end_header',
  ];
  return `${lines.join('\n')}\n`;
}

/** Floats, little-endian. */
function binaryPly(surface: Surface): Uint8Array {
  const { positions, corners, places, colours, materials } = surface;
  const [vertices, faces] = [positions.length / 3, corners.length / 3];
  const header = encode(headerOf('binary_little_endian', 'float', surface));
  const vertexSize = 12 + (places ? 8 : 0) + (colours ? 3 : 0);
  const faceSize = 13 + (materials ? 4 : 0);
  const bytes = new Uint8Array(header.length + vertexSize * vertices + faceSize * faces);
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  let at = header.length;
  const addSingle = (value: number): void => {
    view.setFloat32(at, value, true);
    at += 4;
  };
  const addWhole = (value: number): void => {
    view.setInt32(at, value, true);
    at += 4;
  };
  for (let vertex = 0; vertex < vertices; ++vertex) {
    for (let k = 0; k < 3; ++k) addSingle(positions[3 * vertex + k]!);
    for (let k = 0; places && k < 2; ++k) addSingle(places[2 * vertex + k]!);
    for (let k = 0; colours && k < 3; ++k) bytes[at++] = colours[3 * vertex + k]!;
  }
  for (let face = 0; face < faces; ++face) {
    bytes[at++] = 3;
    for (let k = 0; k < 3; ++k) addWhole(corners[3 * face + k]!);
    if (materials) addWhole(materials[face]!);
  }
  return bytes;
}

/** Text whose last decimal is about as large as the error of what it stands for. */
function textPly(surface: Surface, error: number): Uint8Array {
  // More than 100 cannot be written, and a negative number would round whole units.
  const decimals = Math.min(100, Math.max(0, Math.floor(-Math.log10(error))));
  const word = (value: number): string => (error === 0 ? String(value) : value.toFixed(decimals));
  const { positions, corners, places, colours, materials } = surface;
  const vertexLine = (i: number): string =>
    [
      ...Array.from(positions.subarray(3 * i, 3 * i + 3), word),
      ...Array.from(places?.subarray(2 * i, 2 * i + 2) ?? [], placeWord),
      ...(colours?.subarray(3 * i, 3 * i + 3) ?? []),
    ].join(' ');
  const faceLine = (i: number): string =>
    [3, ...corners.subarray(3 * i, 3 * i + 3), ...(materials?.subarray(i, i + 1) ?? [])].join(' ');
  return concatenated([
    encode(headerOf('ascii', 'double', surface)),
    ...linesOf(positions.length / 3, vertexLine),
    ...linesOf(corners.length / 3, faceLine),
  ]);
}

/**
 * A file of the soup. The engine takes for flat what is flat within the precision of a file, and sees that in
 * how numbers are written: floats where that is what the source comes to, decimals where it is finer or coarser.
 */
export function engineFile(soup: Soup): ModelFile {
  const surface = surfaceOf(soup);
  const single = halfSpacing(largestOf(surface.positions), bitsOfSingle);
  // Maps and unlike sizes of parts change the error of floats by a small factor.
  const isSingle = soup.error >= single / 2 && soup.error <= 4 * single;
  const bytes = isSingle ? binaryPly(surface) : textPly(surface, soup.error);
  return { name: 'model.ply', bytes };
}
