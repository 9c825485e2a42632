/** Absolute addresses of files that are fetched when they are first needed. */
export interface AssetAddresses {
  /** Of the fonts of printed texts, by the names of their files. */
  fonts: Readonly<Record<string, string>>;
  /** Of the modules that draw or read pictures. */
  renderers: { readonly resvg: string; readonly webp: string };
}

export interface AssetLoader {
  /** Fetches a font once, when it is first needed. */
  loadFont: (file: string) => Promise<Uint8Array>;
  /** Fetches a module that draws or reads pictures. */
  loadRenderer: (module: keyof AssetAddresses['renderers']) => Promise<Uint8Array>;
}

async function fetched(address: string, what: string): Promise<Uint8Array> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${what} cannot be loaded (${answer.status})`);
  return new Uint8Array(await answer.arrayBuffer());
}

export function assetLoader({ fonts, renderers }: AssetAddresses): AssetLoader {
  const loaded = new Map<string, Promise<Uint8Array>>();
  return {
    loadFont(file) {
      const known = loaded.get(file);
      if (known) return known;
      const coming = fetched(fonts[file] ?? file, `the font ${file}`);
      loaded.set(file, coming);
      // Another try may succeed.
      coming.catch(() => loaded.delete(file));
      return coming;
    },
    loadRenderer: (module) => fetched(renderers[module], 'the renderer of pictures'),
  };
}
