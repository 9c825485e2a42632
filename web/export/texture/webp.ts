import decode, { init } from '@jsquash/webp/decode.js';
import type { Rgba } from '../../model/rgba.js';
import type { RendererLoader } from '../renderer-loader.js';

let ready: Promise<void> | null = null;

/** Starts the decoder once in each thread. */
export function startWebp(load: RendererLoader): Promise<void> {
  ready ??= load('webp')
    .then((bytes) => WebAssembly.compile(bytes as Uint8Array<ArrayBuffer>))
    .then((module) => init(module));
  // Another try may succeed.
  ready.catch(() => (ready = null));
  return ready;
}

/** @throws Error for a picture that is damaged or moves @pre the decoder was started */
export async function readWebp(bytes: Uint8Array): Promise<Rgba> {
  // A copy: node hands over views of larger buffers, whose own copies are views as well.
  const { width, height, data } = await decode(new Uint8Array(bytes).buffer);
  return { width, height, rgba: new Uint8Array(data.buffer, data.byteOffset, data.length) };
}
