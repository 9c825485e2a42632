/** Where the build has put the fonts of printed texts, by the names of their files. */
const addresses = import.meta.glob<string>(
  [
    '../../node_modules/@fontsource/noto-sans/files/noto-sans-*-400-normal.woff',
    '!../../node_modules/@fontsource/noto-sans/files/noto-sans-devanagari-*',
    '../../node_modules/@fontsource/biz-udpgothic/files/biz-udpgothic-[0-9]*-400-normal.woff',
  ],
  { query: '?url', import: 'default', eager: true },
);

const loaded = new Map<string, Promise<Uint8Array>>();

async function fetchFont(file: string): Promise<Uint8Array> {
  const path = Object.keys(addresses).find((name) => name.endsWith(`/${file}`));
  const answer = await fetch(addresses[path ?? ''] ?? file);
  if (!answer.ok) throw new Error(`the font ${file} cannot be loaded (${answer.status})`);
  return new Uint8Array(await answer.arrayBuffer());
}

/** Fetches a font once, when it is first needed. */
export function loadFont(file: string): Promise<Uint8Array> {
  const known = loaded.get(file);
  if (known) return known;
  const coming = fetchFont(file);
  loaded.set(file, coming);
  // Another try may succeed.
  coming.catch(() => loaded.delete(file));
  return coming;
}
