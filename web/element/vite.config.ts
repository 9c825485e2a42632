import { browserBuild, packageEntries } from '../../scripts/make/browser-build.mjs';

/**
 * The package, as bundlers take it up. They copy what is named by `new URL('assets/..', import.meta.url)`, each file by
 * itself, so workers are whole. All scripts that name such files lie in one folder: a bundler that leaves these addresses
 * alone, as esbuild does, finds them beside its output once the assets are copied there.
 */
export default browserBuild({
  name: 'package',
  entries: packageEntries,
  chunkFolder: '',
  wasmFolder: 'assets/',
  wholeWorkers: true,
});
