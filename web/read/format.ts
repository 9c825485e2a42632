/** Which files are models, by their contents first. */
import type { ModelFile, ModelFiles } from '../model/model-files.js';

/** Formats that are read here; all others are the engine's. */
export type Format = 'glb' | 'gltf' | '3mf' | 'pdo' | 'zip';

const latin = new TextDecoder('latin1');

function textOf(bytes: Uint8Array, begin: number, end?: number): string {
  return latin.decode(bytes.subarray(begin, end));
}

/** The list of names at the end of a ZIP archive of usual size; a longer one is looked at in its last part. */
const namesOfZip = 65_536;

/** Parts of 3MF files lie by convention in "3D", and their first one is named in "_rels/.rels". */
function is3mf(bytes: Uint8Array): boolean {
  const end = textOf(bytes, -namesOfZip);
  return /3D\/[^/]*\.model/i.test(end) || (/_rels\/\.rels/.test(end) && /\.model/i.test(end));
}

/** Bytes at both ends of a file in which its version is looked for: a page calls this while it must answer. */
const ends = 65_536;

/** All glTF files say of which version they are, before or behind all else. */
function isGltf(bytes: Uint8Array): boolean {
  if (!/^(?:\xEF\xBB\xBF)?\s*\{/.test(textOf(bytes, 0, 64))) return false;
  const version = /"asset"\s*:\s*\{[^{}]*"version"/;
  return version.test(textOf(bytes, 0, ends)) || version.test(textOf(bytes, -ends));
}

/** How files of Pepakura Designer begin: since its second version, and before. */
const pdoMark = /^(?:version 3\n|# Pepakura Designer Work Info )/;

/** The format that the contents show; null for one that is not read here. */
export function formatOf(bytes: Uint8Array): Format | null {
  const begin = textOf(bytes, 0, 4);
  if (begin === 'glTF') return 'glb';
  if (begin === 'PK\x03\x04' || begin === 'PK\x05\x06') return is3mf(bytes) ? '3mf' : 'zip';
  if (pdoMark.test(textOf(bytes, 0, 32))) return 'pdo';
  return isGltf(bytes) ? 'gltf' : null;
}

const engineEnding = /\.(obj|stl|off|ply)$/i;

/** Whether the engine may read it, by all that its name tells. */
export function isNamedForEngine({ name, bytes }: ModelFile): boolean {
  return engineEnding.test(name) && formatOf(bytes) === null;
}

/** Whether files must go through the readers of this folder before the engine can read their model. */
export function needsReader(files: ModelFiles): boolean {
  const formats = files.map(({ bytes }) => formatOf(bytes));
  if (formats.some((format) => format !== null && format !== 'zip')) return true;
  return formats.includes('zip') && !files.some(isNamedForEngine);
}

const anyEnding = /\.(obj|stl|off|ply|glb|gltf|3mf|pdo)$/i;

/** Whether an archive with these paths is a 3MF package, of whose names `formatOf` may not have seen all. */
export function isPackage(paths: readonly string[]): boolean {
  return paths.includes('_rels/.rels') && paths.some((path) => /\.model$/i.test(path));
}

const depth = (path: string): number => path.split('/').length;

/** Those paths that end like models, the least deep ones first, and by name. */
export function modelPaths(paths: readonly string[]): string[] {
  return paths
    .filter((path) => anyEnding.test(path))
    .sort((a, b) => depth(a) - depth(b) || (a < b ? -1 : 1));
}
