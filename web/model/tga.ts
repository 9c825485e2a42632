/** Reads TGA pictures (Truevision, version 2.0). */
import { opaqueIfEmpty, widened, type Rgba } from './rgba.js';

const headerLength = 18;

/** Kinds of packing without the bit for runs: colours of a table, colours, and shades of grey. */
const kinds = { table: 1, colours: 2, grey: 3 } as const;

const runs = 8;
const longestRun = 128;

export interface TgaHeader {
  width: number;
  height: number;
  kind: number;
  isPacked: boolean;
  /** Bits per pixel. */
  depth: number;
  /** Bits per pixel that say how much it covers. */
  alphaBits: number;
  isFromRight: boolean;
  isFromAbove: boolean;
  table: { first: number; length: number; depth: number };
  /** Where the table of colours begins. */
  begin: number;
}

const depths: Readonly<Record<number, readonly number[]>> = {
  [kinds.table]: [8, 16],
  [kinds.colours]: [15, 16, 24, 32],
  [kinds.grey]: [8, 16],
};

/** What a file begins with; null for one that is no such picture. The format has no mark, so all fields are looked at. */
export function tgaHeader(bytes: Uint8Array): TgaHeader | null {
  if (bytes.length < headerLength) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [hasTable, packing, depth, descriptor] = [1, 2, 16, 17].map((at) => view.getUint8(at));
  const kind = packing! & ~runs;
  const table = {
    first: view.getUint16(3, true),
    length: view.getUint16(5, true),
    depth: view.getUint8(7),
  };
  const isKnown = depths[kind]?.includes(depth!) === true && hasTable! <= 1 && descriptor! < 64;
  const isTableKnown = hasTable === 1 && [15, 16, 24, 32].includes(table.depth);
  if (!isKnown || (kind === kinds.table ? !isTableKnown : hasTable === 1 && !isTableKnown))
    return null;
  return {
    width: view.getUint16(12, true),
    height: view.getUint16(14, true),
    kind,
    isPacked: (packing! & runs) !== 0,
    depth: depth!,
    alphaBits: descriptor! & 15,
    isFromRight: (descriptor! & 16) !== 0,
    isFromAbove: (descriptor! & 32) !== 0,
    table: hasTable === 1 ? table : { first: 0, length: 0, depth: 0 },
    begin: headerLength + view.getUint8(0),
  };
}

const bytesOf = (depth: number): number => Math.ceil(depth / 8);

/** The pixels as they are without runs; null where the file ends before them. */
function unpacked(
  bytes: Uint8Array,
  begin: number,
  size: number,
  count: number,
): Uint8Array | null {
  // Before memory is asked for: a run has 128 pixels at most.
  if (count > longestRun * bytes.length) return null;
  const pixels = new Uint8Array(size * count);
  let at = begin;
  for (let done = 0; done < pixels.length;) {
    if (at >= bytes.length) return null;
    const packet = bytes[at++]!;
    const length = Math.min(size * ((packet & 127) + 1), pixels.length - done);
    const taken = packet & 128 ? size : length;
    if (at + taken > bytes.length) return null;
    if (packet & 128) {
      for (let i = 0; i < length; ++i) pixels[done + i] = bytes[at + (i % size)]!;
    } else {
      pixels.set(bytes.subarray(at, at + length), done);
    }
    at += taken;
    done += length;
  }
  return pixels;
}

function plain(bytes: Uint8Array, begin: number, length: number): Uint8Array | null {
  return begin + length > bytes.length ? null : bytes.subarray(begin, begin + length);
}

/** Writes the colour at `from`, of so many bits, to `to`. */
type Write = (source: Uint8Array, from: number, target: Uint8Array, to: number) => void;

function colourWriter(depth: number, hasAlpha: boolean): Write {
  if (depth >= 24) {
    return (source, from, target, to) => {
      target[to] = source[from + 2]!;
      target[to + 1] = source[from + 1]!;
      target[to + 2] = source[from]!;
      target[to + 3] = hasAlpha && depth === 32 ? source[from + 3]! : 255;
    };
  }
  return (source, from, target, to) => {
    const word = source[from]! | (source[from + 1]! << 8);
    [10, 5, 0].forEach((bits, i) => (target[to + i] = widened((word >> bits) & 31, 31)));
    target[to + 3] = hasAlpha && depth === 16 && word < 0x8000 ? 0 : 255;
  };
}

function greyWriter(depth: number, hasAlpha: boolean): Write {
  return (source, from, target, to) => {
    target.fill(source[from]!, to, to + 3);
    target[to + 3] = hasAlpha && depth === 16 ? source[from + 1]! : 255;
  };
}

/** Colours of the table by their numbers; those that are not in it are black. */
function tableWriter({ table, depth, alphaBits }: TgaHeader, colours: Uint8Array): Write {
  const size = bytesOf(table.depth);
  const write = colourWriter(table.depth, alphaBits > 0);
  return (source, from, target, to) => {
    const number = depth === 8 ? source[from]! : source[from]! | (source[from + 1]! << 8);
    const index = number - table.first;
    if (index >= 0 && index < table.length) write(colours, size * index, target, to);
    else target[to + 3] = 255;
  };
}

function writerOf(header: TgaHeader, colours: Uint8Array): Write {
  const hasAlpha = header.alphaBits > 0;
  if (header.kind === kinds.table) return tableWriter(header, colours);
  if (header.kind === kinds.grey) return greyWriter(header.depth, hasAlpha);
  return colourWriter(header.depth, hasAlpha);
}

/** @returns null for a picture that is damaged @pre its size is one that can be held */
export function readTga(bytes: Uint8Array): Rgba | null {
  const header = tgaHeader(bytes);
  if (!header) return null;
  const { width, height, depth, table, begin } = header;
  const tableLength = bytesOf(table.depth) * table.length;
  const colours = plain(bytes, begin, tableLength);
  const [size, count, first] = [bytesOf(depth), width * height, begin + tableLength];
  const pixels = header.isPacked
    ? unpacked(bytes, first, size, count)
    : plain(bytes, first, size * count);
  if (!colours || !pixels) return null;
  const rgba = new Uint8Array(4 * count);
  const write = writerOf(header, colours);
  for (let i = 0; i < count; ++i) {
    const [column, row] = [i % width, Math.floor(i / width)];
    const x = header.isFromRight ? width - 1 - column : column;
    const y = header.isFromAbove ? row : height - 1 - row;
    write(pixels, size * i, rgba, 4 * (y * width + x));
  }
  opaqueIfEmpty(rgba);
  return { width, height, rgba };
}
