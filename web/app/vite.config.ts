import { fileURLToPath } from 'node:url';
import { browserBuild, packageEntries } from '../../scripts/make/browser-build.mjs';
import { precache } from '../../scripts/make/vite-plugins.mjs';

const path = (relative: string): string => fileURLToPath(new URL(relative, import.meta.url));

/** The studio, as hosts serve it; other pages find the scripts of the package beside it. */
export default browserBuild({
  name: 'studio',
  entries: {
    index: path('index.html'),
    'viewer-frame': path('viewer-frame.html'),
    ...packageEntries,
  },
  chunkFolder: 'assets/',
  // The WASM lies beside the page, where hosts and people expect it.
  wasmFolder: '',
  plugins: [precache(path('../pwa/service-worker.ts'))],
});
