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

/** Formats of models by their endings; an archive is the last to be one. */
const modelEndings = [/\.(obj|stl|off|ply|glb|gltf|3mf|pdo)$/i, /\.zip$/i];

/** Adds up files before they are read. */
export class FileLimits {
  private bytes = 0;
  private count = 0;

  /** What is too much of them, as in "it has ...", or null if nothing is. */
  add(size: number): string | null {
    this.bytes += size;
    if (++this.count > mostFiles) return `more than ${mostFiles} files`;
    const megabytes = Math.ceil(this.bytes / 2 ** 20);
    return megabytes > mostMegabytes
      ? `${megabytes} MB, and ${mostMegabytes} MB can be read`
      : null;
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
