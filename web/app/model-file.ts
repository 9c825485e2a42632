/** A model as it was chosen: its file's name and bytes. */
export interface ModelFile {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

/** A choice that gives no model; the message is a sentence for the person who chose. */
export class UnusableChoice extends Error {}

/** MiB. The engine has 2 GiB of memory, and what it reads of a file takes up to three times its size. */
const largest = 512;

function checkSize({ name, size }: File): void {
  if (size <= largest * 2 ** 20) return;
  throw new UnusableChoice(
    `“${name}” is too large: it has ${Math.ceil(size / 2 ** 20)} MB, and ${largest} MB can be read. ` +
      'Save it with fewer faces, or in a binary format.',
  );
}

/** The part of an address that names the file. */
function fileNameOf(address: string): string {
  const last =
    address
      .replace(/[?#].*$/, '')
      .split('/')
      .at(-1) ?? '';
  try {
    return decodeURIComponent(last);
  } catch {
    // A percent sign of its own.
    return last;
  }
}

/**
 * Fetches a model from an address, which may be relative to `base`. Throws UnusableChoice for one that is not
 * there, empty or too large.
 */
export async function fetchModelFile(
  address: string,
  base: string,
  signal: AbortSignal,
): Promise<ModelFile> {
  const name = fileNameOf(address);
  let bytes: Blob;
  try {
    const response = await fetch(new URL(address, base), { signal });
    if (!response.ok) throw new Error(response.statusText);
    bytes = await response.blob();
  } catch {
    throw new UnusableChoice(`“${name}” cannot be loaded.`);
  }
  return readModelFile([new File([bytes], name)]);
}

/**
 * Reads the one file of a choice. Throws UnusableChoice for several files, and for one that is empty,
 * unreadable or too large.
 */
export async function readModelFile(files: readonly File[]): Promise<ModelFile> {
  const [file, ...others] = files;
  if (!file) throw new UnusableChoice('That was no file. Choose an OBJ, STL, OFF or PLY file.');
  if (others.length > 0) {
    throw new UnusableChoice(
      `Those were ${files.length} files. Foldwright unfolds one model at a time: ` +
        'choose a single OBJ, STL, OFF or PLY file.',
    );
  }
  checkSize(file);
  const bytes = await file.arrayBuffer().catch(() => {
    throw new UnusableChoice(
      `“${file.name}” cannot be read: it is a folder, or it was moved, or may not be opened.`,
    );
  });
  if (bytes.byteLength === 0) {
    throw new UnusableChoice(`“${file.name}” is empty: there is nothing in it to unfold.`);
  }
  return { name: file.name, bytes: new Uint8Array(bytes) };
}
