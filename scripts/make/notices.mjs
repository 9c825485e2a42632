// THIRD_PARTY_NOTICES: the licences of everything that is inside the built package, from the packages' own files.
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root, toolchain } from '../setup/paths.mjs';
import { shippedFolder } from './vite-plugins.mjs';

// Compiled into the WASM. Where a system keeps no licence file, the licence's name has to do.
const compiled = [
  { name: 'Eigen', licence: 'MPL-2.0', file: '/usr/share/doc/libeigen3-dev/copyright' },
  { name: 'Spectra', licence: 'MPL-2.0', file: '/usr/share/doc/libspectra-dev/copyright' },
  { name: 'OpenMesh', licence: 'BSD-3-Clause', file: join(toolchain, 'src/openmesh/LICENSE') },
  {
    name: 'Emscripten with musl, libc++, libc++abi and compiler-rt',
    licence: 'MIT, Apache-2.0 WITH LLVM-exception',
    file: join(toolchain, 'emsdk/emscripten/copyright'),
  },
];

function bundledPackages() {
  const notes = readdirSync(shippedFolder).map((name) => join(shippedFolder, name));
  const folders = notes.flatMap((note) => JSON.parse(readFileSync(note, 'utf8')));
  return [...new Set(folders)].sort().map((folder) => {
    const { name, version, license } = JSON.parse(
      readFileSync(join(folder, 'package.json'), 'utf8'),
    );
    const file = readdirSync(folder).find((entry) => /^(licen[cs]e|copying)/i.test(entry));
    return { name: `${name} ${version}`, licence: license, file: file && join(folder, file) };
  });
}

function section({ name, licence, file }) {
  const text = file && existsSync(file) ? readFileSync(file, 'utf8').trim() : `Licence: ${licence}`;
  return `${name} (${licence})\n${'-'.repeat(72)}\n${text}\n`;
}

export function writeNotices() {
  const sections = [...compiled, ...bundledPackages()].map(section);
  const head =
    `Foldwright contains the following software, unmodified, each under its own licence. Their sources are\n` +
    `available from the projects and packages of these names.\n`;
  writeFileSync(join(root, 'dist/THIRD_PARTY_NOTICES'), [head, ...sections].join('\n\n'));
}
