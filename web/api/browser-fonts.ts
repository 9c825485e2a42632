/** Fetches a font that came with the package; the build puts them beside it. */
export async function fetchFont(file: string): Promise<Uint8Array> {
  const answer = await fetch(new URL(`fonts/${file}`, import.meta.url));
  if (!answer.ok) throw new Error(`the font ${file} cannot be loaded (${answer.status})`);
  return new Uint8Array(await answer.arrayBuffer());
}
