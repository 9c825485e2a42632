// Sets the machine up for building (and, with --with-browser, for testing). Does nothing when all is there.
import { operatingSystem } from './setup/apt-sources.mjs';
import { debianPackages } from './setup/debian-packages.mjs';
import { emscripten } from './setup/emscripten.mjs';
import { npmPackages } from './setup/npm.mjs';
import { openMesh } from './setup/openmesh.mjs';
import { SetupError } from './setup/shell.mjs';

const options = { withBrowser: process.argv.includes('--with-browser') };

const steps = [
  () => debianPackages(options),
  emscripten,
  // Elsewhere CMake asks for OpenMesh's source itself.
  () => operatingSystem().id === 'debian' && openMesh(),
  npmPackages,
];

try {
  for (const step of steps) step();
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`setup: ${error.message}`);
  process.exit(1);
}
