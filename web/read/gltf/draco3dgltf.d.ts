/** The part of the decoder that is used here; the package has no types of its own. */
declare module 'draco3dgltf/draco_decoder_gltf_nodejs.js' {
  interface Options {
    instantiateWasm(
      imports: WebAssembly.Imports,
      done: (instance: WebAssembly.Instance) => void,
    ): object;
    printErr(text: string): void;
  }
  const createDecoder: (options: Options) => Promise<object>;
  export default createDecoder;
}
