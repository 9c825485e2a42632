import { readFile } from 'node:fs/promises';
import type { RendererModule } from '../export/renderer-loader.js';

/** Reads a module that draws or reads pictures, which the build puts beside the program. */
export async function readRendererFile(module: RendererModule): Promise<Uint8Array> {
  return new Uint8Array(await readFile(new URL(`${module}.wasm`, import.meta.url)));
}
