/** Where the models of a viewer come from. */
import { fetchModelFile } from '../../app/model-file.js';
import { isFoldName, titleOf, type ModelFile, type ModelFiles } from '../../model/model-files.js';
import { readFoldedNets, type FoldedNets } from '../../read/fold/folded-nets.js';
import { Unreadable } from '../../read/unreadable.js';
import type { Exhibit } from './exhibit.js';
import { ViewerError } from './viewer-fault.js';

/** What can be shown. */
export type ViewerSource = string | URL | File | ModelFiles;

/** Whether a name or address is that of a FOLD file. */
export function isFold(name: string): boolean {
  return isFoldName(name.replace(/[?#].*$/, ''));
}

/** @throws ViewerError for a FOLD file that holds something else */
export function exhibitOf(file: ModelFile): Exhibit {
  const found = foundIn(file);
  if (!found) throw new ViewerError('not-fold');
  const { pieces } = found;
  return { ...found, title: titleOf(file.name), nets: [{ kind: 'pattern', pieces }], sheets: 0 };
}

function foundIn(file: ModelFile): FoldedNets | null {
  try {
    return readFoldedNets(file);
  } catch (error) {
    if (error instanceof Unreadable) return null;
    throw error;
  }
}

/** The files of a model; rejects with a `ViewerError` if they cannot be loaded. */
export async function filesOf(
  source: ViewerSource,
  base: string,
  signal: AbortSignal,
): Promise<ModelFiles> {
  if (source instanceof File) {
    return [{ name: source.name, bytes: new Uint8Array(await source.arrayBuffer()) }];
  }
  if (typeof source !== 'string' && !(source instanceof URL)) return source;
  try {
    return (await fetchModelFile(String(source), base, signal)).files;
  } catch {
    signal.throwIfAborted();
    throw new ViewerError('not-loaded');
  }
}
