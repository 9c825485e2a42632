/** What a PDO file says of its sheets. */
import { BrokenPdo, type PdoBytes } from './pdo-bytes.js';
import type { PdoHeader } from './pdo-header.js';
import { readPicture } from './pdo-materials.js';
import { skipText } from './pdo-strings.js';

export interface PdoPattern {
  /** Millimetres on paper per unit of the model. */
  scale: number;
  /** Width and height of each part on paper in mm, flaps included. */
  parts: [number, number][];
  /** How many texts and pictures lie on the sheets, beside those on the parts. */
  texts: number;
  images: number;
}

const bytesPerBox = 32;

function readSize(bytes: PdoBytes): [number, number] {
  bytes.skip(16); // left and top
  return [bytes.f64(), bytes.f64()];
}

/** A line of a part, with the faces on one side of it or on both. */
function skipLine(bytes: PdoBytes): void {
  bytes.skip(5);
  for (let sides = 2; sides > 0; --sides) if (bytes.bool()) bytes.skip(8);
}

function readPart(bytes: PdoBytes, version: number): [number, number] {
  bytes.skip(4); // the object that it is of
  const size = readSize(bytes);
  if (version > 4) skipText(bytes);
  for (let left = bytes.count(7); left > 0; --left) skipLine(bytes);
  return size;
}

function skipWords(bytes: PdoBytes): void {
  bytes.skip(bytesPerBox + 16);
  skipText(bytes);
  for (let left = bytes.count(4); left > 0; --left) skipText(bytes);
}

function skipImages(bytes: PdoBytes): number {
  const count = bytes.count(bytesPerBox + 12);
  for (let left = count; left > 0; --left) {
    bytes.skip(bytesPerBox);
    readPicture(bytes);
  }
  return count;
}

/** Null for a model that was never unfolded. @throws BrokenPdo */
export function readPattern(bytes: PdoBytes, { version }: PdoHeader): PdoPattern | null {
  if (!bytes.bool()) return null;
  const begin = bytes.at;
  const scale = bytes.f64();
  if (!(scale > 0 && scale < Infinity)) throw new BrokenPdo(begin);
  bytes.skip(1 + bytesPerBox);
  const least = 4 + bytesPerBox + 4;
  const parts = Array.from({ length: bytes.count(least) }, () => readPart(bytes, version));
  const texts = bytes.count(bytesPerBox + 24);
  for (let left = texts; left > 0; --left) skipWords(bytes);
  const images = skipImages(bytes) + skipImages(bytes);
  return { scale, parts, texts, images };
}
