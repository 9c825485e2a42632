import { readFile } from 'node:fs/promises';

/** Reads the renderer of PNG files, which the build puts beside the program. */
export async function readRendererFile(): Promise<Uint8Array> {
  return new Uint8Array(await readFile(new URL('resvg.wasm', import.meta.url)));
}
