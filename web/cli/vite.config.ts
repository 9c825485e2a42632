import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { copyFonts, copyWasm, notePackages } from '../../scripts/make/vite-plugins.mjs';

const path = (relative: string): string => fileURLToPath(new URL(relative, import.meta.url));

/** The command line: self-contained, so that the published package depends on nothing. */
export default defineConfig({
  root: path('.'),
  publicDir: false,
  plugins: [notePackages('cli'), copyWasm(), copyFonts()],
  ssr: { noExternal: true },
  // The decoder of Draco asks where it lies, which modules do not have; its WASM is handed to it.
  define: { __dirname: '""' },
  build: {
    ssr: true,
    target: 'node20',
    outDir: path('../../dist/cli'),
    emptyOutDir: true,
    rolldownOptions: {
      input: {
        foldwright: path('foldwright.ts'),
        index: path('../api/node.ts'),
        'node-worker': path('../core/node-worker.ts'),
        'batch-slot': path('batch/batch-slot.ts'),
      },
      output: {
        entryFileNames: '[name].js',
        // Beside the entries: code that looks for its neighbours by import.meta.url finds them from any chunk.
        chunkFileNames: '[name].js',
      },
    },
  },
});
