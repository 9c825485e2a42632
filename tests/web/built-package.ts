/** The built package as programs get it; its types are those of its sources. */
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import type * as NodePackage from '../../web/api/node.js';
import type * as ViewerPackage from '../../web/element/foldwright-viewer.js';

/** An address that neither the compiler nor the tests' own bundler looks into. */
const built = (path: string): string => new URL(`../../dist/${path}`, import.meta.url).href;

export function nodePackage(): Promise<typeof NodePackage> {
  return import(built('cli/index.js')) as Promise<typeof NodePackage>;
}

/** The script of the viewer, which does nothing where there is no DOM. */
export function viewerPackage(): Promise<typeof ViewerPackage> {
  return import(built('package/foldwright-viewer.js')) as Promise<typeof ViewerPackage>;
}

/** A script of it as a text. */
export function builtText(path: string): Promise<string> {
  return readFile(fileURLToPath(built(path)), 'utf8');
}
