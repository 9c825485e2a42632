/** Absolute addresses of what a browser's worker loads; its name is the JSON of them. */
export interface WorkerAddresses {
  /** The engine. */
  wasm: string;
  /** The decoder of Draco. */
  draco: string;
  /** The library that unites bodies. */
  manifold: string;
}
