// What the bundles for browsers have in common: the studio, for hosts, and the package, for bundlers.
import { join } from 'node:path';
import { root } from '../setup/paths.mjs';
import { integrity, notePackages, sampleAddresses, withoutNodeModules } from './vite-plugins.mjs';

/** Scripts that other pages and programs call by their names. */
export const packageEntries = {
  'foldwright-studio': join(root, 'web/element/foldwright-studio.ts'),
  'foldwright-viewer': join(root, 'web/element/foldwright-viewer.ts'),
  foldwright: join(root, 'web/api/browser.ts'),
};

/** Names by contents, which keep caches right. */
function assetNames(wasmFolder) {
  return ({ names }) => {
    // That of the renderer of pictures is called by no more than "index" in its package.
    if (names.includes('index_bg.wasm')) return `${wasmFolder}resvg-[hash][extname]`;
    const isWasm = names.some((name) => name.endsWith('.wasm'));
    return `${isWasm ? wasmFolder : 'assets/'}[name]-[hash][extname]`;
  };
}

/**
 * @param {object} options
 * @param {string} options.name of the bundle and its folder in `dist/`
 * @param {Record<string, string>} options.entries scripts and pages by their names
 * @param {string} options.chunkFolder where scripts lie that no one calls by their names, with a slash at its end
 * @param {string} options.wasmFolder where WASM lies, in the same way
 * @param {boolean} [options.wholeWorkers] whether the script of a worker is a single file, which may be moved
 * @param {import('vite').Plugin[]} [options.plugins]
 * @returns {import('vite').UserConfig} a bundle for any folder of any host: every address in it is relative
 */
export function browserBuild(options) {
  const { name, entries, chunkFolder, wasmFolder, wholeWorkers = false, plugins = [] } = options;
  const assetFileNames = assetNames(wasmFolder);
  const ofWorkers = notePackages(`${name}-worker`);
  const chunkFileNames = `${chunkFolder}[name]-[hash].js`;
  return {
    root: join(root, 'web/app'),
    base: './',
    plugins: [notePackages(name), withoutNodeModules(), sampleAddresses(), ...plugins, integrity()],
    worker: {
      format: 'es',
      plugins: () => [ofWorkers, withoutNodeModules()],
      rolldownOptions: { output: { assetFileNames, codeSplitting: !wholeWorkers } },
    },
    build: {
      outDir: join(root, 'dist', name),
      emptyOutDir: true,
      // The first browsers with module workers, WASM SIMD and WASM exceptions.
      target: ['chrome95', 'firefox114', 'safari16.4'],
      // The content security policy forbids data: addresses for most kinds of files.
      assetsInlineLimit: 0,
      modulePreload: {
        // What scripts load later is not announced in the document: the package may run where there is none.
        resolveDependencies: (_, files, { hostType }) => (hostType === 'html' ? files : []),
      },
      // The 3D view, which loads after the page, is three.js for the most part.
      chunkSizeWarningLimit: wholeWorkers ? 2000 : 700,
      rolldownOptions: {
        input: entries,
        preserveEntrySignatures: 'allow-extension',
        output: {
          assetFileNames,
          chunkFileNames,
          entryFileNames: ({ name: entry }) =>
            entry in packageEntries ? '[name].js' : chunkFileNames,
        },
      },
    },
  };
}
