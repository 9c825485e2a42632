/** Says in a PNG file how large its pixels are on paper. */

const [signatureLength, headerLength] = [8, 25];

/** What each value of a byte does to the remainder. */
const steps = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; ++bit) value = (value >>> 1) ^ (value & 1 ? 0xedb88320 : 0);
  return value;
});

/** The remainder that PNG puts behind each chunk (CRC-32 of ISO 3309). */
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

/** The chunk pHYs for square pixels, so many to the metre. */
function physicalSize(perMetre: number): Uint8Array {
  const data = new Uint8Array(9);
  const view = new DataView(data.buffer);
  view.setUint32(0, perMetre);
  view.setUint32(4, perMetre);
  const inMetres = 1;
  view.setUint8(8, inMetres);
  return pngChunk('pHYs', data);
}

/** A PNG file without that chunk, with it. */
export function withPhysicalSize(png: Uint8Array, dpi: number): Uint8Array {
  const chunk = physicalSize(Math.round(dpi / 0.0254));
  // Right behind the header, which comes first: it must come before the pixels.
  const start = signatureLength + headerLength;
  const whole = new Uint8Array(png.length + chunk.length);
  whole.set(png.subarray(0, start));
  whole.set(chunk, start);
  whole.set(png.subarray(start), start + chunk.length);
  return whole;
}
