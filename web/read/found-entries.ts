import type { ZipBytes, ZipEntry } from './zip-directory.js';

const localSignature = 0x04034b50;
const localLength = 30;

const utf8 = new TextDecoder();

/** An entry as its own header tells it. */
function entryAt(zip: ZipBytes, offset: number): ZipEntry {
  const flags = zip.u16(offset + 6);
  return {
    name: utf8.decode(zip.slice(offset + localLength, zip.u16(offset + 26))),
    method: zip.u16(offset + 8),
    isLocked: (flags & 1) !== 0,
    checksum: zip.u32(offset + 14),
    packedSize: zip.u32(offset + 18),
    size: zip.u32(offset + 22),
    offset,
  };
}

/**
 * Entries of an archive whose list is damaged or cut off, as far as they are there. Only for archives whose
 * headers tell the sizes, as those that we write do.
 */
export function* foundEntries(zip: ZipBytes): Generator<ZipEntry> {
  const last = zip.bytes.length - localLength;
  for (
    let at = zip.bytes.indexOf(0x50);
    at >= 0 && at <= last;
    at = zip.bytes.indexOf(0x50, at + 1)
  ) {
    if (zip.u32(at) !== localSignature) continue;
    const nameLength = zip.u16(at + 26);
    if (at + localLength + nameLength <= zip.bytes.length) yield entryAt(zip, at);
  }
}
