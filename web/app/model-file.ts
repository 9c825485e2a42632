/** A model as it was chosen: its file's name and bytes. */
export interface ModelFile {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

/** A choice that gives no model; the message is a sentence for the person who chose. */
export class UnusableChoice extends Error {}

/** Reads the one file of a choice. Throws UnusableChoice for several files, empty or unreadable ones. */
export async function readModelFile(files: readonly File[]): Promise<ModelFile> {
  const [file, ...others] = files;
  if (!file) throw new UnusableChoice('That was no file. Choose an OBJ, STL, OFF or PLY file.');
  if (others.length > 0) {
    throw new UnusableChoice(
      `Those were ${files.length} files. Foldwright unfolds one model at a time: ` +
        'choose a single OBJ, STL, OFF or PLY file.',
    );
  }
  const bytes = await file.arrayBuffer().catch(() => {
    throw new UnusableChoice(`“${file.name}” cannot be read. Folders cannot be unfolded.`);
  });
  if (bytes.byteLength === 0) {
    throw new UnusableChoice(`“${file.name}” is empty: there is nothing in it to unfold.`);
  }
  return { name: file.name, bytes: new Uint8Array(bytes) };
}
