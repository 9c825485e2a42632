/** Reads BMP pictures of Windows and OS/2. */
import { opaqueIfEmpty, widened, type Rgba } from './rgba.js';

const fileHeader = 14;

const packings = { none: 0, runs8: 1, runs4: 2, masks: 3, alphaMasks: 6 } as const;

export interface BmpHeader {
  width: number;
  height: number;
  isFromAbove: boolean;
  /** Bits per pixel. */
  depth: number;
  packing: number;
  /** Where the pixels begin. */
  pixels: number;
  /** Where the table of colours begins, how many there are at most, and how many bytes each has. */
  table: { begin: number; length: number; size: number };
  /** Bits of red, green, blue and of how much a pixel covers; of 16 and 32 bits per pixel. */
  masks: readonly number[];
}

const usualMasks: Readonly<Record<number, readonly number[]>> = {
  16: [0x7c00, 0x3e0, 0x1f, 0],
  32: [0xff0000, 0xff00, 0xff, 0],
};

const known: Readonly<Record<number, readonly number[]>> = {
  [packings.none]: [1, 4, 8, 16, 24, 32],
  [packings.runs8]: [8],
  [packings.runs4]: [4],
  [packings.masks]: [16, 32],
  [packings.alphaMasks]: [16, 32],
};

/** Four numbers that stand behind the fields of the oldest header that can have them. */
function masksOf(
  view: DataView,
  { packing, depth, size }: Record<'packing' | 'depth' | 'size', number>,
): readonly number[] {
  const isMasked = packing === packings.masks || packing === packings.alphaMasks;
  if (!isMasked) return usualMasks[depth] ?? [];
  const begin = fileHeader + 40;
  const hasAlpha = size >= 56 || packing === packings.alphaMasks;
  const at = (i: number): number =>
    begin + 4 * i + 4 <= view.byteLength ? view.getUint32(begin + 4 * i, true) : 0;
  return [at(0), at(1), at(2), hasAlpha ? at(3) : 0];
}

/** What a file begins with; null for one that is no such picture, or of a kind that hardly any program writes. */
export function bmpHeader(bytes: Uint8Array): BmpHeader | null {
  if (bytes.length < fileHeader + 12 || bytes[0] !== 0x42 || bytes[1] !== 0x4d) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [pixels, size] = [view.getUint32(10, true), view.getUint32(14, true)];
  const isOld = size === 12;
  if (!isOld && (size < 40 || bytes.length < fileHeader + 40)) return null;
  const width = isOld ? view.getUint16(18, true) : view.getInt32(18, true);
  const height = isOld ? view.getUint16(20, true) : view.getInt32(22, true);
  const depth = view.getUint16(isOld ? 24 : 28, true);
  const packing = isOld ? packings.none : view.getUint32(30, true);
  if (width < 0 || known[packing]?.includes(depth) !== true) return null;
  const asked = isOld ? 0 : view.getUint32(46, true);
  const most = depth <= 8 ? 2 ** depth : 0;
  return {
    width,
    height: Math.abs(height),
    isFromAbove: height < 0,
    depth,
    packing,
    pixels,
    table: { begin: fileHeader + size, length: Math.min(asked || most, most), size: isOld ? 3 : 4 },
    masks: masksOf(view, { packing, depth, size }),
  };
}

/** Numbers in the table of colours, row by row from the one that the file begins with; null for a damaged file. */
type Numbers = Uint8Array | null;

function plainNumbers(bytes: Uint8Array, { width, height, depth, pixels }: BmpHeader): Numbers {
  const stride = 4 * Math.ceil((width * depth) / 32);
  if (pixels + stride * height > bytes.length) return null;
  const [numbers, perByte] = [new Uint8Array(width * height), 8 / depth];
  for (let row = 0, to = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      const byte = bytes[pixels + row * stride + Math.floor(column / perByte)]!;
      const shift = depth * (perByte - 1 - (column % perByte));
      numbers[to++] = (byte >> shift) & (2 ** depth - 1);
    }
  }
  return numbers;
}

/** Pixels per byte of a file with runs: four times as many as the longest runs give, for what is left out. */
const mostGrowth = 512;

/** Numbers in runs; what is left out has the first colour. */
function unpackedNumbers(bytes: Uint8Array, header: BmpHeader): Numbers {
  const { width, height, depth, pixels } = header;
  if (width * height > mostGrowth * bytes.length) return null;
  const numbers = new Uint8Array(width * height);
  let [at, x, y] = [pixels, 0, 0];
  const put = (number: number): void => {
    if (x < width && y < height) numbers[y * width + x] = number;
    ++x;
  };
  const valueIn = (byte: number, i: number): number =>
    depth === 8 ? byte : i % 2 === 0 ? byte >> 4 : byte & 15;
  while (y < height) {
    if (at + 2 > bytes.length) return null;
    const [length, value] = [bytes[at]!, bytes[at + 1]!];
    at += 2;
    if (length > 0) {
      for (let i = 0; i < length; ++i) put(valueIn(value, i));
    } else if (value === 0) {
      [x, y] = [0, y + 1];
    } else if (value === 1) {
      break;
    } else if (value === 2) {
      if (at + 2 > bytes.length) return null;
      [x, y] = [x + bytes[at]!, y + bytes[at + 1]!];
      at += 2;
    } else {
      const taken = depth === 8 ? value : Math.ceil(value / 2);
      if (at + taken > bytes.length) return null;
      for (let i = 0; i < value; ++i) put(valueIn(bytes[at + (depth === 8 ? i : i >> 1)]!, i));
      // Such stretches end at even places.
      at += taken + (taken % 2);
    }
  }
  return numbers;
}

/** Writes the pixel with a number, counted in the order of the file, to a place. */
type Write = (pixel: number, rgba: Uint8Array, to: number) => void;

function tableWriter(bytes: Uint8Array, header: BmpHeader): Write | null {
  const isPacked = header.packing !== packings.none;
  const numbers = isPacked ? unpackedNumbers(bytes, header) : plainNumbers(bytes, header);
  if (!numbers) return null;
  const { begin, length, size } = header.table;
  return (pixel, rgba, to) => {
    const at = begin + size * numbers[pixel]!;
    const isThere = numbers[pixel]! < length && at + 3 <= bytes.length;
    for (let i = 0; i < 3; ++i) rgba[to + i] = isThere ? bytes[at + 2 - i]! : 0;
    rgba[to + 3] = 255;
  };
}

/** Takes the bits of a mask out of a pixel; `without` stands where it has none. */
function channel(mask: number, without: number): (word: number) => number {
  if (mask === 0) return () => without;
  const shift = 31 - Math.clz32(mask & -mask);
  const most = mask >>> shift;
  return (word) => widened(((word & mask) >>> shift) & most, most);
}

function colourWriter(
  bytes: Uint8Array,
  { width, height, depth, pixels, masks }: BmpHeader,
): Write | null {
  const [size, stride] = [depth / 8, 4 * Math.ceil((width * depth) / 32)];
  if (pixels + stride * height > bytes.length) return null;
  const [red, green, blue, cover] = masks.map((mask, i) => channel(mask, i === 3 ? 255 : 0));
  return (pixel, rgba, to) => {
    const at = pixels + Math.floor(pixel / width) * stride + (pixel % width) * size;
    if (depth === 24) {
      for (let i = 0; i < 3; ++i) rgba[to + i] = bytes[at + 2 - i]!;
      rgba[to + 3] = 255;
      return;
    }
    let word = 0;
    for (let i = 0; i < size; ++i) word |= bytes[at + i]! << (8 * i);
    [red!, green!, blue!, cover!].forEach((part, i) => (rgba[to + i] = part(word)));
  };
}

/** @returns null for a picture that is damaged @pre its size is one that can be held */
export function readBmp(bytes: Uint8Array): Rgba | null {
  const header = bmpHeader(bytes);
  if (!header) return null;
  const { width, height, depth, isFromAbove } = header;
  const write = depth <= 8 ? tableWriter(bytes, header) : colourWriter(bytes, header);
  if (!write) return null;
  const rgba = new Uint8Array(4 * width * height);
  for (let pixel = 0; pixel < width * height; ++pixel) {
    const row = Math.floor(pixel / width);
    const y = isFromAbove ? row : height - 1 - row;
    write(pixel, rgba, 4 * (y * width + (pixel % width)));
  }
  opaqueIfEmpty(rgba);
  return { width, height, rgba };
}
