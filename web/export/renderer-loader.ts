/** Reads the WebAssembly module that draws pictures, which comes along as a file of its own. */
export type RendererLoader = () => Promise<Uint8Array>;
