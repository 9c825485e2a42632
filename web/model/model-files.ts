/** The files that a model comes in, from wherever it is chosen to the engine. */

/** A file as it was read. */
export interface ModelFile {
  /** May have folders before it: `textures/wood.png`. Its ending tells the format where the bytes do not. */
  name: string;
  bytes: Uint8Array;
}

/**
 * A model and what came along with it, in any order. Which of them is the model, the engine sees by
 * their contents; the others, such as materials and pictures, are its companions.
 */
export type ModelFiles = readonly ModelFile[];

/** MiB. The engine has 2 GiB of memory, and what it reads of a file takes up to three times its size. */
const mostMegabytes = 512;

/** Far more than come with any model; whoever gives more has chosen another folder by mistake. */
export const mostFiles = 1000;

const modelEnding = /\.(obj|stl|off|ply|glb|gltf|3mf|pdo)$/i;
const archiveEnding = /\.zip$/i;
const foldEnding = /\.fold$/i;

/** Formats by their endings in the order in which they are taken for the model: FOLD files are mostly made of one. */
const modelEndings = [modelEnding, foldEnding, archiveEnding];

/** Whether a file is a model or an archive of one, by its name. FOLD files count only where they are meant. */
export function isModelName(name: string): boolean {
  return modelEnding.test(name) || archiveEnding.test(name);
}

/** Whether a file is called a FOLD file. */
export function isFoldName(name: string): boolean {
  return foldEnding.test(name);
}

/** What is too much of the files of a choice. */
export type FileExcess =
  { what: 'too-many'; most: number } | { what: 'too-large'; megabytes: number; most: number };

/** Adds up files before they are read. */
export class FileLimits {
  private bytes = 0;
  private count = 0;

  /** What is too much of them, or null if nothing is. */
  add(size: number): FileExcess | null {
    this.bytes += size;
    if (++this.count > mostFiles) return { what: 'too-many', most: mostFiles };
    const megabytes = Math.ceil(this.bytes / 2 ** 20);
    return megabytes > mostMegabytes ? { what: 'too-large', megabytes, most: mostMegabytes } : null;
  }
}

/** Whether a file is one of those that systems hide in folders. */
export function isHidden(name: string): boolean {
  return name.split('/').some((part) => part.startsWith('.'));
}

/** Name of the file that is the model by all that names tell; the engine may see that it is another. */
export function probableModel(files: ModelFiles): string {
  const named = modelEndings.map((ending) => files.find(({ name }) => ending.test(name)));
  return (named.find((file) => file) ?? files[0])?.name ?? '';
}

/** What a model is called by the name of its file: without folders and ending. */
export function titleOf(fileName: string): string {
  return fileName.replace(/^.*[/\\]/, '').replace(/(?<=.)\.[^.]*$/, '');
}
