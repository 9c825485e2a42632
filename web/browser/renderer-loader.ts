import address from '@resvg/resvg-wasm/index_bg.wasm?url';

/** Fetches the renderer of PNG files from where the build has put it. */
export async function loadRenderer(): Promise<Uint8Array> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`the renderer of pictures cannot be loaded (${answer.status})`);
  return new Uint8Array(await answer.arrayBuffer());
}
