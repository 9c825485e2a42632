import { readFile } from 'node:fs/promises';

/** Reads a font that came with the program; the build puts them beside it. */
export async function readFontFile(file: string): Promise<Uint8Array> {
  return new Uint8Array(await readFile(new URL(`fonts/${file}`, import.meta.url)));
}
