/** How a PNG file is put together. */

/** What each value of a byte does to the remainder. */
const steps = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; ++bit) value = (value >>> 1) ^ (value & 1 ? 0xedb88320 : 0);
  return value;
});

/** The remainder that PNG puts behind each chunk, and ZIP has of each file (CRC-32 of ISO 3309). */
export function remainder(bytes: Uint8Array): number {
  let value = 0xffffffff;
  for (const byte of bytes) value = (value >>> 8) ^ steps[(value ^ byte) & 255]!;
  return ~value >>> 0;
}

/** A chunk of a PNG file, with its length before it and its remainder behind. */
export function pngChunk(type: string, data: Uint8Array): Uint8Array {
  const chunk = new Uint8Array(12 + data.length);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, data.length);
  chunk.set(new TextEncoder().encode(type), 4);
  chunk.set(data, 8);
  view.setUint32(8 + data.length, remainder(chunk.subarray(4, 8 + data.length)));
  return chunk;
}

export interface PngSize {
  /** Pixels. */
  width: number;
  height: number;
  /** Values of a byte per pixel: colours without or with transparency. */
  channels: 3 | 4;
}

function header({ width, height, channels }: PngSize): Uint8Array {
  const data = new Uint8Array(13);
  const view = new DataView(data.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  data[8] = 8; // bits per value
  data[9] = channels === 4 ? 6 : 2;
  return data;
}

/** A PNG file. @param rows filtered, each behind the number of its filter, and compressed (zlib) */
export function pngAround(size: PngSize, rows: Uint8Array): Uint8Array {
  const parts = [
    Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a),
    pngChunk('IHDR', header(size)),
    pngChunk('IDAT', rows),
    pngChunk('IEND', new Uint8Array()),
  ];
  const whole = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
