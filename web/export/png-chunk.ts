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

/** The chunk pHYs for square pixels, so many to the metre. */
function physicalSize(perMetre: number): Uint8Array {
  const dataLength = 9;
  const chunk = new Uint8Array(12 + dataLength);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, dataLength);
  chunk.set(new TextEncoder().encode('pHYs'), 4);
  view.setUint32(8, perMetre);
  view.setUint32(12, perMetre);
  const inMetres = 1;
  view.setUint8(16, inMetres);
  view.setUint32(17, remainder(chunk.subarray(4, 17)));
  return chunk;
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
