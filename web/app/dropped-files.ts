/** What is dropped on the page: files, and folders with all that is in them. */
import { isHidden, mostFiles } from '../model/model-files.js';
import { UnusableChoice, type PickedFile } from './model-file.js';

type Callbacks<Value> = (resolve: (value: Value) => void, reject: (error: Error) => void) => void;

/** Waits for what the older interface of folders gives to callbacks. */
function given<Value>(name: string, ask: Callbacks<Value>): Promise<Value> {
  return new Promise<Value>(ask).catch(() => {
    throw new UnusableChoice(({ choice }) => choice.unreadableDrop(name));
  });
}

/** A folder gives what is in it in portions; the last one is empty. */
async function contentsOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const entries: FileSystemEntry[] = [];
  for (;;) {
    const portion = await given<FileSystemEntry[]>(folder.name, (resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (portion.length === 0) return entries;
    entries.push(...portion);
  }
}

/** Adds the files of a folder and of the folders in it; ends early where nobody wants so many. */
async function addFolder(
  folder: FileSystemDirectoryEntry,
  prefix: string,
  found: PickedFile[],
): Promise<void> {
  for (const entry of await contentsOf(folder)) {
    if (isHidden(entry.name)) continue;
    if (found.length > mostFiles) return;
    const path = prefix + entry.name;
    if (entry.isDirectory) {
      await addFolder(entry as FileSystemDirectoryEntry, `${path}/`, found);
    } else {
      const file = await given<File>(path, (resolve, reject) =>
        (entry as FileSystemFileEntry).file(resolve, reject),
      );
      found.push({ path, file });
    }
  }
}

/**
 * The files of a drop, those in folders by their path within the folder that was dropped. Must be called
 * while the event is heard: afterwards it holds nothing. Rejects with UnusableChoice.
 */
export async function droppedFiles(transfer: DataTransfer): Promise<PickedFile[]> {
  const dropped = [...transfer.items]
    .filter(({ kind }) => kind === 'file')
    .map((item) => ({ entry: item.webkitGetAsEntry(), file: item.getAsFile() }));
  const found: PickedFile[] = [];
  for (const { entry, file } of dropped) {
    if (entry?.isDirectory) await addFolder(entry as FileSystemDirectoryEntry, '', found);
    else if (file) found.push({ path: file.name, file });
  }
  return found;
}
