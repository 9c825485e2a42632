import webp from '@jsquash/webp/codec/dec/webp_dec.wasm?url';
import resvg from '@resvg/resvg-wasm/index_bg.wasm?url';

const addresses = { resvg, webp } as const;

/** Fetches a module that draws or reads pictures from where the build has put it. */
export async function loadRenderer(module: keyof typeof addresses): Promise<Uint8Array> {
  const answer = await fetch(addresses[module]);
  if (!answer.ok) throw new Error(`the renderer of pictures cannot be loaded (${answer.status})`);
  return new Uint8Array(await answer.arrayBuffer());
}
