/** Runs the readers in this thread, and looks at the triangles that they hand to the engine. */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { ModelFile, ModelFiles } from '../../web/model/model-files.js';
import { readFiles } from '../../web/read/read-files.js';
import type { ReadModel } from '../../web/read/read-model.js';
import { Unreadable } from '../../web/read/unreadable.js';
import { englishPhrase } from '../../web/words/phrase.js';
import { parsePly, type LookedTriangles } from './ply-file.js';

const dracoFile = fileURLToPath(
  new URL('../../node_modules/draco3dgltf/draco_decoder_gltf.wasm', import.meta.url),
);

export function read(...files: ModelFile[]): Promise<ReadModel> {
  return readFiles(files, { loadDraco: () => Promise.resolve(readFileSync(dracoFile)) });
}

/** The sentence with which files are refused; "read" if they are not. Whatever else is thrown is a fault. */
export async function refusal(files: ModelFiles): Promise<string> {
  try {
    await read(...files);
    return 'read';
  } catch (error) {
    if (!(error instanceof Unreadable)) throw error;
    return englishPhrase(error);
  }
}

export interface Triangles {
  positions: number[];
  corners: number[];
}

/** The triangles of a file as readers write it. */
export function trianglesOf({ bytes }: ModelFile): LookedTriangles {
  return parsePly(bytes);
}

/** Six times the signed volume, over six: positive where outsides are outside. */
export function volumeOf({ positions, corners }: Triangles): number {
  const point = (corner: number): number[] => positions.slice(3 * corner, 3 * corner + 3);
  let sum = 0;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [point(corners[i]!), point(corners[i + 1]!), point(corners[i + 2]!)];
    sum +=
      a[0]! * (b[1]! * c[2]! - b[2]! * c[1]!) -
      a[1]! * (b[0]! * c[2]! - b[2]! * c[0]!) +
      a[2]! * (b[0]! * c[1]! - b[1]! * c[0]!);
  }
  return sum / 6;
}

/** Extents along x, y and z, to a ten-thousandth. */
export function sizeOf({ positions }: Triangles): number[] {
  return [0, 1, 2].map((axis) => {
    const values = positions.filter((_, i) => i % 3 === axis);
    const extent =
      values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
    return Number(extent.toFixed(4));
  });
}

/** Bytes of which one has another value. */
export function changed(bytes: Uint8Array, at: number, value: number): Uint8Array {
  const copy = bytes.slice();
  copy[at] = value;
  return copy;
}

/** What is to be told, as codes. */
export const codesOf = ({ notices }: ReadModel): string[] => notices.map(({ code }) => code);
