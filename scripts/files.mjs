import { existsSync, readdirSync } from 'node:fs';
import { join, relative } from 'node:path';
import { root } from './setup/paths.mjs';

const generated = 'web/core/generated';

/** Paths below the folders, relative to the root, that end in one of `endings`; generated files left out. */
export function sourceFiles(folders, endings) {
  return folders
    .filter((folder) => existsSync(join(root, folder)))
    .flatMap((folder) => readdirSync(join(root, folder), { recursive: true, withFileTypes: true }))
    .filter((entry) => entry.isFile() && endings.some((ending) => entry.name.endsWith(ending)))
    .map((entry) => relative(root, join(entry.parentPath ?? entry.path, entry.name)))
    .filter((path) => !path.startsWith(generated))
    .sort();
}
