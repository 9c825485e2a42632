/** The list of contents at the end of a ZIP archive (APPNOTE 6.3.10, sections 4.3.12 to 4.3.16). */

/** What the list says of a file. */
export interface ZipEntry {
  name: string;
  /** 0: as it is, 8: deflated. */
  method: number;
  isLocked: boolean;
  checksum: number;
  packedSize: number;
  size: number;
  /** Of its own header in the archive. */
  offset: number;
}

/** An archive whose list leads nowhere. */
export class BrokenZip extends Error {}

const signatures = { local: 0x04034b50, entry: 0x02014b50, end: 0x06054b50, wideEnd: 0x06064b50 };
/** Sizes of the headers without what has no fixed length. */
const lengths = { local: 30, entry: 46, end: 22, wideLocator: 20 };
/** Stands for a number that is given in 64 bits elsewhere. */
const elsewhere = 0xffff_ffff;
const longestComment = 0xffff;

const utf8 = new TextDecoder();
// Names without the flag of UTF-8 are in whatever the system had: for ASCII all are alike.
const latin = new TextDecoder('latin1');

/** Reads of numbers that fail with BrokenZip beyond the end. */
export class ZipBytes {
  private readonly view: DataView;

  constructor(readonly bytes: Uint8Array) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  u16(at: number): number {
    this.check(at, 2);
    return this.view.getUint16(at, true);
  }

  u32(at: number): number {
    this.check(at, 4);
    return this.view.getUint32(at, true);
  }

  u64(at: number): number {
    return this.u32(at) + 2 ** 32 * this.u32(at + 4);
  }

  slice(at: number, length: number): Uint8Array {
    this.check(at, length);
    return this.bytes.subarray(at, at + length);
  }

  private check(at: number, length: number): void {
    if (!(at >= 0 && at + length <= this.bytes.length)) throw new BrokenZip();
  }
}

/** Where the list begins, and how many entries it has. */
function placeOfList(zip: ZipBytes): { at: number; count: number } {
  const last = zip.bytes.length - lengths.end;
  for (let end = last; end >= Math.max(0, last - longestComment); --end) {
    if (zip.u32(end) !== signatures.end) continue;
    const [count, at] = [zip.u16(end + 10), zip.u32(end + 16)];
    if (at !== elsewhere && count !== 0xffff) return { at, count };
    const wide = zip.u64(end - lengths.wideLocator + 8);
    if (zip.u32(wide) !== signatures.wideEnd) return { at, count };
    return { at: zip.u64(wide + 48), count: zip.u64(wide + 32) };
  }
  throw new BrokenZip();
}

/** Numbers that do not fit into 32 bits, in the order in which they are missing. */
function wideNumbers(zip: ZipBytes, at: number, length: number): number[] {
  for (let field = at; field + 4 <= at + length; field += 4 + zip.u16(field + 2)) {
    if (zip.u16(field) !== 1) continue;
    const count = Math.floor(zip.u16(field + 2) / 8);
    return Array.from({ length: count }, (_, i) => zip.u64(field + 4 + 8 * i));
  }
  return [];
}

function entryAt(zip: ZipBytes, at: number): { entry: ZipEntry; next: number } {
  if (zip.u32(at) !== signatures.entry) throw new BrokenZip();
  const [nameLength, extraLength] = [zip.u16(at + 28), zip.u16(at + 30)];
  const flags = zip.u16(at + 8);
  const name = zip.slice(at + lengths.entry, nameLength);
  const extra = at + lengths.entry + nameLength;
  const wide = wideNumbers(zip, extra, extraLength);
  const number = (place: number): number => {
    const value = zip.u32(place);
    return value === elsewhere ? (wide.shift() ?? value) : value;
  };
  const [size, packedSize, offset] = [number(at + 24), number(at + 20), number(at + 42)];
  const entry: ZipEntry = {
    name: (flags & 0x800 ? utf8 : latin).decode(name),
    method: zip.u16(at + 10),
    isLocked: (flags & 1) !== 0,
    checksum: zip.u32(at + 16),
    packedSize,
    size,
    offset,
  };
  return { entry, next: extra + extraLength + zip.u16(at + 32) };
}

/** All entries, one after the other. @throws BrokenZip */
export function* zipEntries(zip: ZipBytes): Generator<ZipEntry> {
  const { at: first, count } = placeOfList(zip);
  let at = first;
  for (let i = 0; i < count; ++i) {
    const { entry, next } = entryAt(zip, at);
    yield entry;
    at = next;
  }
}

/** The bytes of an entry as they are packed. @throws BrokenZip */
export function packedBytes(zip: ZipBytes, { offset, packedSize }: ZipEntry): Uint8Array {
  if (zip.u32(offset) !== signatures.local) throw new BrokenZip();
  const begin = offset + lengths.local + zip.u16(offset + 26) + zip.u16(offset + 28);
  return zip.slice(begin, packedSize);
}
