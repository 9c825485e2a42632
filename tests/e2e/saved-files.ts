import { unzipSync } from 'fflate';

/** A file that the page saves. */
export interface SavedFile {
  name: string;
  bytes: Uint8Array;
}

/** The files of a download, which may be an archive of several. */
export function filesOf({ name, bytes }: SavedFile): SavedFile[] {
  if (!name.endsWith('.zip')) return [{ name, bytes }];
  const entries = Object.entries(unzipSync(bytes));
  return entries.map(([entry, content]) => ({ name: entry, bytes: content }));
}
