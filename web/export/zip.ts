import { zipSync, type Zippable } from 'fflate';
import type { WrittenFile } from './formats.js';

// The first day that a zip archive can name: the same files give the same bytes.
const noDate = new Date(1980, 0, 1);

/** Files as one zip archive. */
export function zipped(files: readonly WrittenFile[]): Uint8Array {
  const entries: Zippable = {};
  for (const { name, bytes } of files) entries[name] = bytes;
  return zipSync(entries, { mtime: noDate });
}
