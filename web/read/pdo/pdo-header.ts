import { BrokenPdo, type PdoBytes } from './pdo-bytes.js';
import { skipText, type TextForm } from './pdo-strings.js';

/** Versions of the binary format that are read: those of Pepakura Designer 2 to 6. */
const versions = [4, 5, 6];

export interface PdoHeader {
  /** 4, 5 or 6. */
  version: number;
  text: TextForm;
  /** Whether its author has locked it against changes. */
  isLocked: boolean;
}

/** A file of a version that is not read. */
export class UnknownPdo extends Error {
  constructor(readonly version: number) {
    super(`version ${version}`);
  }
}

/** `version 3` and a line end. */
const markLength = 10;

/** Reads all before the objects. @throws BrokenPdo, UnknownPdo */
export function readHeader(bytes: PdoBytes): PdoHeader {
  bytes.skip(markLength);
  const version = bytes.u32();
  if (!versions.includes(version)) throw new UnknownPdo(version);
  const isWide = (bytes.u32() & 1) === 1;
  bytes.skip(4); // build of the program
  let shift = 0;
  if (version > 4) {
    skipText(bytes); // name of the program
    shift = bytes.u32() & 255;
  }
  skipText(bytes); // language
  skipText(bytes); // code page
  const isLocked = bytes.u32() !== 0;
  if (version === 6) bytes.skip(2); // whether notes are shown, and a flag
  skipText(bytes); // a checksum of the lock
  if (version === 6) bytes.skip(8 * bytes.count(8));
  if (version === 5) bytes.skip(2);
  const extent = bytes.f64();
  if (!Number.isFinite(extent)) throw new BrokenPdo(bytes.at - 8);
  bytes.skip(3 * 8); // middle of the model
  return { version, text: { isWide, shift }, isLocked };
}
