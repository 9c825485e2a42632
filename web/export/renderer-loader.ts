/** Modules of WebAssembly that come along as files of their own: what draws pictures, and what reads those of WebP. */
export type RendererModule = 'resvg' | 'webp';

/** Reads one of these modules. */
export type RendererLoader = (module: RendererModule) => Promise<Uint8Array>;
