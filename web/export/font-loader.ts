/** Reads a file of `fontSlices`. */
export type FontLoader = (file: string) => Promise<Uint8Array>;
