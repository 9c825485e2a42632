// The source of OpenMesh 9.0, as the distribution keeps it; CMake compiles what is needed of it.
import { mkdirSync, readdirSync, renameSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { operatingSystem } from './apt-sources.mjs';
import { toolchain } from './paths.mjs';
import { privateApt } from './private-apt.mjs';
import { once } from './stamp.mjs';

export function openMesh() {
  once(
    'openmesh',
    '9.0',
    () => {
      const folder = join(toolchain, 'src');
      rmSync(folder, { recursive: true, force: true });
      mkdirSync(folder, { recursive: true });
      privateApt('deb-src', operatingSystem().codename)(['source', 'openmesh'], folder);
      // `openmesh-9.0` or the like; the archives it came from lie beside it.
      const unpacked = readdirSync(folder, { withFileTypes: true });
      const tree = unpacked.find(
        (entry) => entry.isDirectory() && entry.name.startsWith('openmesh'),
      );
      for (const entry of unpacked) if (entry !== tree) rmSync(join(folder, entry.name));
      renameSync(join(folder, tree.name), join(folder, 'openmesh'));
    },
    [join(toolchain, 'src/openmesh')],
  );
}
