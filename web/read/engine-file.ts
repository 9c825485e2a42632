/** Writes triangles so that the engine reads them with the precision that they have. */
import type { ModelFile } from '../model/model-files.js';
import { bitsOfSingle, halfSpacing, largestOf } from './precision.js';
import type { Soup } from './soup.js';

const encode = (text: string): Uint8Array => new TextEncoder().encode(text);

/** Floats, little-endian. */
function plyOf(positions: Float64Array, corners: Int32Array): Uint8Array {
  const [vertices, faces] = [positions.length / 3, corners.length / 3];
  const header = encode(
    `ply\nformat binary_little_endian 1.0\nelement vertex ${vertices}\n` +
      'property float x\nproperty float y\nproperty float z\n' +
      `element face ${faces}\nproperty list uchar int vertex_indices\nend_header\n`,
  );
  const bytes = new Uint8Array(header.length + 12 * vertices + 13 * faces);
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  let at = header.length;
  for (const value of positions) {
    view.setFloat32(at, value, true);
    at += 4;
  }
  for (let i = 0; i < corners.length; i += 3) {
    view.setUint8(at, 3);
    for (let k = 0; k < 3; ++k) view.setInt32(at + 1 + 4 * k, corners[i + k]!, true);
    at += 13;
  }
  return bytes;
}

/** Lines that are joined at a time: one string for all of them may be longer than strings can be. */
const linesPerBlock = 10_000;

function linesOf(count: number, line: (index: number) => string): Uint8Array[] {
  const blocks: Uint8Array[] = [];
  for (let first = 0; first < count; first += linesPerBlock) {
    const length = Math.min(linesPerBlock, count - first);
    const lines = Array.from({ length }, (_, i) => line(first + i));
    blocks.push(encode(`${lines.join('\n')}\n`));
  }
  return blocks;
}

function concatenated(blocks: readonly Uint8Array[]): Uint8Array {
  const bytes = new Uint8Array(blocks.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const block of blocks) {
    bytes.set(block, at);
    at += block.length;
  }
  return bytes;
}

/** Text whose last decimal is about as large as the error of what it stands for. */
function offOf(positions: Float64Array, corners: Int32Array, error: number): Uint8Array {
  // More than 100 cannot be written, and a negative number would round whole units.
  const decimals = Math.min(100, Math.max(0, Math.floor(-Math.log10(error))));
  const word = (value: number): string => (error === 0 ? String(value) : value.toFixed(decimals));
  const [vertices, faces] = [positions.length / 3, corners.length / 3];
  return concatenated([
    encode(`OFF\n${vertices} ${faces} 0\n`),
    ...linesOf(vertices, (i) => [...positions.subarray(3 * i, 3 * i + 3)].map(word).join(' ')),
    ...linesOf(faces, (i) => `3 ${corners.subarray(3 * i, 3 * i + 3).join(' ')}`),
  ]);
}

/**
 * A file of the soup. The engine takes for flat what is flat within the precision of a file, and sees that in
 * how numbers are written: floats where that is what the source comes to, decimals where it is finer or coarser.
 */
export function engineFile(soup: Soup): ModelFile {
  const [positions, corners] = [soup.positions(), soup.corners()];
  const single = halfSpacing(largestOf(positions), bitsOfSingle);
  // Maps and unlike sizes of parts change the error of floats by a small factor.
  const isSingle = soup.error >= single / 2 && soup.error <= 4 * single;
  return isSingle
    ? { name: 'model.ply', bytes: plyOf(positions, corners) }
    : { name: 'model.off', bytes: offOf(positions, corners, soup.error) };
}
