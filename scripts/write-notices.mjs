// THIRD_PARTY_NOTICES: the licences of everything that is inside the built package, from the packages' own files, or as SPDX
// has their texts where a package brings none.
import { existsSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import licences from 'spdx-license-list/full.js';
import { root, toolchain } from './setup/paths.mjs';
import { SetupError, main } from './setup/shell.mjs';
import { shippedFolder } from './make/vite-plugins.mjs';

// Compiled into the WASM.
const compiled = [
  { name: 'Eigen', licence: 'MPL-2.0', files: ['/usr/share/doc/libeigen3-dev/copyright'] },
  { name: 'Spectra', licence: 'MPL-2.0', files: ['/usr/share/doc/libspectra-dev/copyright'] },
  { name: 'OpenMesh', licence: 'BSD-3-Clause', files: [join(toolchain, 'src/openmesh/LICENSE')] },
  {
    name: 'Emscripten with musl, libc++, libc++abi and compiler-rt',
    licence: 'MIT, Apache-2.0 WITH LLVM-exception',
    files: [join(toolchain, 'emsdk/emscripten/copyright')],
  },
];

function bundledPackages() {
  const notes = readdirSync(shippedFolder).map((name) => join(shippedFolder, name));
  const folders = notes.flatMap((note) => JSON.parse(readFileSync(note, 'utf8')));
  return [...new Set(folders)].sort().map((folder) => {
    const { name, version, license, author } = JSON.parse(
      readFileSync(join(folder, 'package.json'), 'utf8'),
    );
    const holder = typeof author === 'object' ? author.name : author?.replace(/ *<.*/, '');
    return { name: `${name} ${version}`, licence: license, holder, files: licenceFiles(folder) };
  });
}

/** Of a package, and of what it has compiled into itself. */
function licenceFiles(folder) {
  return readdirSync(folder, { recursive: true })
    .filter((path) => /^(?!.*node_modules\b).*?\b(licen[cs]e|copying)[^/]*$/i.test(path))
    .map((path) => join(folder, path))
    .filter((path) => statSync(path).isFile())
    .sort();
}

/** The text of a licence by its name, or of several. */
function standardText(licence) {
  const names = licence.match(/[\w.+-]+/g).filter((name) => Object.hasOwn(licences, name));
  if (names.length === 0) throw new SetupError(`no text of the licence ${licence} is known`);
  return names.map((name) => licences[name].licenseText.trim()).join('\n\n');
}

function section({ name, licence, holder, files }) {
  const found = files.filter((file) => existsSync(file));
  const own = found.map((file) => readFileSync(file, 'utf8').trim());
  const standard = () => [...(holder ? [`Copyright ${holder}`] : []), standardText(licence)];
  const text = (own.length > 0 ? own : standard()).join('\n\n');
  return `${name} (${licence})\n${'-'.repeat(72)}\n${text}\n`;
}

main(() => {
  const sections = [...compiled, ...bundledPackages()].map(section);
  const head =
    `Foldwright contains the following software, unmodified, each under its own licence. Their sources are\n` +
    `available from the projects and packages of these names.\n`;
  writeFileSync(join(root, 'dist/THIRD_PARTY_NOTICES'), [head, ...sections].join('\n\n'));
});
