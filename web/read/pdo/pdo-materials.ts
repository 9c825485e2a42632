/** The materials of a PDO file: colours and the pixels of pictures. */
import { ofShown, type Colour } from '../colours.js';
import type { PdoBytes } from './pdo-bytes.js';
import { readText, type TextForm } from './pdo-strings.js';

/** A picture as the file has it. */
export interface PdoPicture {
  /** Pixels. */
  width: number;
  height: number;
  /** Red, green and blue of all rows from above, packed (zlib). */
  packed: Uint8Array;
}

export interface PdoMaterial {
  name: string;
  colour: Colour;
  picture: PdoPicture | null;
}

const bytesPerColour = 16;

export function readPicture(bytes: PdoBytes): PdoPicture {
  const [width, height] = [bytes.u32(), bytes.u32()];
  return { width, height, packed: bytes.block(bytes.count(1)) };
}

function readMaterial(bytes: PdoBytes, text: TextForm): PdoMaterial {
  const name = readText(bytes, text);
  bytes.skip(bytesPerColour); // in the shade
  const shares = [bytes.f32(), bytes.f32(), bytes.f32()];
  bytes.skip(4 + 3 * bytesPerColour); // shine, glow, and the colour on paper, which is the same
  return { name, colour: ofShown(shares), picture: bytes.bool() ? readPicture(bytes) : null };
}

/** @throws BrokenPdo */
export function readMaterials(bytes: PdoBytes, text: TextForm): PdoMaterial[] {
  const least = 4 + 5 * bytesPerColour + 1;
  return Array.from({ length: bytes.count(least) }, () => readMaterial(bytes, text));
}
