// Sets the machine up, step by step; each step does nothing when its result is there.
import { operatingSystem } from './apt-sources.mjs';
import { debianPackages } from './debian-packages.mjs';
import { emscripten } from './emscripten.mjs';
import { npmPackages } from './npm.mjs';
import { openMesh } from './openmesh.mjs';

/**
 * @param options.withBrowser also what only the tests need
 * @param options.withEngines also what only the tests in three engines need
 */
export function setUp({ withBrowser = false, withEngines = false } = {}) {
  debianPackages({ withBrowser, withEngines });
  emscripten();
  if (operatingSystem().id === 'debian') openMesh(); // elsewhere CMake asks for its source itself
  npmPackages();
}
