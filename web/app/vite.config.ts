import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { notePackages, precache, withoutNodeModules } from '../../scripts/make/vite-plugins.mjs';

const path = (relative: string): string => fileURLToPath(new URL(relative, import.meta.url));

// The WASM lies beside the page, where hosts and people expect it; its hash keeps caches right. That of
// the renderer of pictures is called by no more than "index" in its package.
const output = {
  assetFileNames: ({ names }: { names: string[] }): string => {
    if (names.includes('index_bg.wasm')) return 'resvg-[hash][extname]';
    return names.some((name) => name.endsWith('.wasm'))
      ? '[name]-[hash][extname]'
      : 'assets/[name]-[hash][extname]';
  },
};

const entries = {
  index: path('index.html'),
  // For other pages: under a name that they can rely on.
  'foldwright-studio': path('../element/foldwright-studio.ts'),
  foldwright: path('../api/browser.ts'),
};
const entryFileNames = ({ name }: { name: string }): string =>
  name.startsWith('foldwright') ? '[name].js' : 'assets/[name]-[hash].js';

/** The studio, for any folder of any host: every address in it is relative. */
export default defineConfig({
  root: path('.'),
  base: './',
  plugins: [
    notePackages('studio'),
    withoutNodeModules(),
    precache(path('../pwa/service-worker.ts')),
  ],
  worker: {
    format: 'es',
    plugins: () => [notePackages('studio-worker'), withoutNodeModules()],
    rolldownOptions: { output },
  },
  build: {
    outDir: path('../../dist/studio'),
    emptyOutDir: true,
    // The first browsers with module workers, WASM SIMD and WASM exceptions.
    target: ['chrome95', 'firefox114', 'safari16.4'],
    // The content security policy forbids data: addresses for most kinds of files.
    assetsInlineLimit: 0,
    modulePreload: {
      // What scripts load later is not announced in the document: the package may run where there is none.
      resolveDependencies: (
        _: string,
        files: string[],
        { hostType }: { hostType: 'html' | 'js' },
      ) => (hostType === 'html' ? files : []),
    },
    // The 3D view, which loads after the page, is three.js for the most part.
    chunkSizeWarningLimit: 700,
    rolldownOptions: {
      input: entries,
      preserveEntrySignatures: 'allow-extension',
      output: { ...output, entryFileNames },
    },
  },
});
