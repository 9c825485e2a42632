import type { ModelFile } from '../model/model-files.js';
import { places, projectEnding } from './project.js';

const latin = new TextDecoder('latin1');

/** Bytes of the header of an archive's first file, before its name. */
const headerLength = 30;

/** Whether a file is a project, by its beginning, or at least by its name. */
export function isProject({ name, bytes }: ModelFile): boolean {
  if (name.toLowerCase().endsWith(projectEnding)) return true;
  const begin = latin.decode(bytes.subarray(0, headerLength + places.document.length));
  return begin.startsWith('PK\x03\x04') && begin.slice(headerLength) === places.document;
}
