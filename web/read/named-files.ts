/** Which other files a model is made of, by what its own file says. */
import type { ModelFile } from '../model/model-files.js';
import { formatOf } from './format.js';
import { namedFiles as namedByGltf } from './gltf/buffers.js';
import { openContainer } from './gltf/container.js';
import { readMtl } from './mtl.js';
import { librariesIn, namesOfLine } from './obj-libraries.js';
import { plyPictures } from './ply-pictures.js';

/** Finds the file of an address in the file `base`; null for one that is not there. */
export type FindFile = (address: string, base: string) => ModelFile | null;

function namedIn(model: ModelFile): string[] {
  const format = formatOf(model.bytes);
  if (format === null) return plyPictures(model.bytes);
  if (format !== 'glb' && format !== 'gltf') return [];
  try {
    return namedByGltf(openContainer(model, format === 'glb').json);
  } catch {
    // Whoever reads it says why it is unreadable.
    return [];
  }
}

/** Addresses of the pictures of a library of materials. */
function picturesIn(bytes: Uint8Array): string[] {
  return readMtl(bytes).flatMap(({ picture }) => picture?.path ?? []);
}

/**
 * The files that a model's file names, and those that these name: buffers, materials and pictures, as far as they
 * are found. Each address is looked for once.
 */
export function companionsOf(model: ModelFile, find: FindFile): ModelFile[] {
  const { name, bytes } = model;
  const asked = new Set<string>();
  const found = new Map<string, ModelFile>();
  const take = (address: string, base: string): ModelFile | null => {
    const question = `${base}\n${address}`;
    if (asked.has(question)) return null;
    asked.add(question);
    const file = find(address, base);
    if (file) found.set(file.name, file);
    return file;
  };
  for (const address of namedIn(model)) take(address, name);
  const libraries = formatOf(bytes) === null ? librariesIn(bytes) : [];
  for (const address of libraries.flatMap(namesOfLine)) {
    const library = take(address, name);
    for (const path of library ? picturesIn(library.bytes) : []) take(path, library!.name);
  }
  return [...found.values()];
}
