/** Says in a PNG file how large its pixels are on paper. */
import { pngChunk } from '../model/png-file.js';

const [signatureLength, headerLength] = [8, 25];

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
