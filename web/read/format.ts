/** Which files are models, by their contents first. */
import { isFoldName, type ModelFile, type ModelFiles } from '../model/model-files.js';

/** Formats that are read here; all others are the engine's. */
export type Format = 'glb' | 'gltf' | '3mf' | 'pdo' | 'fold' | 'zip';

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
const gltfMark = /"asset"\s*:\s*\{[^{}]*"version"/;

/** Names that only FOLD files have: the first ones by convention before all else. */
const foldMark = /"(?:file_spec|file_creator|frame_classes|vertices_coords|faces_vertices)"\s*:/;

/** Whether a text in JSON has something near its begin or its end. */
function isJsonWith(bytes: Uint8Array, mark: RegExp): boolean {
  if (!/^(?:\xEF\xBB\xBF)?\s*\{/.test(textOf(bytes, 0, 64))) return false;
  return mark.test(textOf(bytes, 0, ends)) || mark.test(textOf(bytes, -ends));
}

/** How files of Pepakura Designer begin: since its second version, and before. */
const pdoMark = /^(?:version 3\n|# Pepakura Designer Work Info )/;

/** The format that the contents show; null for one that is not read here. */
export function formatOf(bytes: Uint8Array): Format | null {
  const begin = textOf(bytes, 0, 4);
  if (begin === 'glTF') return 'glb';
  if (begin === 'PK\x03\x04' || begin === 'PK\x05\x06') return is3mf(bytes) ? '3mf' : 'zip';
  if (pdoMark.test(textOf(bytes, 0, 32))) return 'pdo';
  if (isJsonWith(bytes, gltfMark)) return 'gltf';
  return isJsonWith(bytes, foldMark) ? 'fold' : null;
}

/** The same of a file: what is called a FOLD file is read as one, so that what is wrong with it can be told. */
export function formatOfFile({ name, bytes }: ModelFile): Format | null {
  return formatOf(bytes) ?? (isFoldName(name) ? 'fold' : null);
}

/** Formats of files that are a model only where there is no other: archives, and what was made of a model. */
function isLastResort(format: Format | null): boolean {
  return format === 'zip' || format === 'fold';
}

const engineEnding = /\.(obj|stl|off|ply)$/i;

/** Whether the engine may read it, by all that its name tells. */
export function isNamedForEngine({ name, bytes }: ModelFile): boolean {
  return engineEnding.test(name) && formatOf(bytes) === null;
}

/** Whether files must go through the readers of this folder before the engine can read their model. */
export function needsReader(files: ModelFiles): boolean {
  const formats = files.map(formatOfFile);
  if (formats.some((format) => format !== null && !isLastResort(format))) return true;
  return formats.some(isLastResort) && !files.some(isNamedForEngine);
}

/** Those of some files that are read as models: FOLD files only where there is nothing else. */
export function modelsAmong(files: ModelFiles): ModelFile[] {
  const formats = files.map(formatOfFile);
  const models = files.filter((file, i) => {
    return isNamedForEngine(file) || (formats[i] !== null && !isLastResort(formats[i]!));
  });
  return models.length > 0 ? models : files.filter((_, i) => formats[i] === 'fold');
}

const anyEnding = /\.(obj|stl|off|ply|glb|gltf|3mf|pdo)$/i;

/** Whether an archive with these paths is a 3MF package, of whose names `formatOf` may not have seen all. */
export function isPackage(paths: readonly string[]): boolean {
  return paths.includes('_rels/.rels') && paths.some((path) => /\.model$/i.test(path));
}

const depth = (path: string): number => path.split('/').length;

/** Those paths that end like models, or else like FOLD files; the least deep ones first, and by name. */
export function modelPaths(paths: readonly string[]): string[] {
  const models = paths.filter((path) => anyEnding.test(path));
  const found = models.length > 0 ? models : paths.filter(isFoldName);
  return found.sort((a, b) => depth(a) - depth(b) || (a < b ? -1 : 1));
}
