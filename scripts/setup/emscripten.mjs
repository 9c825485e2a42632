// Emscripten, as `.toolchain/emscripten.cmake` for CMake: the one on the PATH when it is new enough, else the next
// Debian release's package in a private prefix, since the running release's own is too old (no ES6 output for node,
// no type declarations, half of the C++20 library).
import {
  chmodSync,
  existsSync,
  mkdirSync,
  readdirSync,
  realpathSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { delimiter, dirname, join } from 'node:path';
import { toolchain } from './paths.mjs';
import { privateApt } from './private-apt.mjs';
import { capture, run } from './shell.mjs';
import { fingerprint, once } from './stamp.mjs';

const suite = 'trixie';
const llvm = '/usr/lib/llvm-19/bin'; // the version Emscripten 3.1.69 was packaged with
const packages = ['emscripten', 'binaryen', 'node-acorn', 'libc6', 'libstdc++6', 'libgcc-s1'];

// Most of the package's 1.7 GB are tests, documents and library variants that nothing here links.
const unwanted = [
  ...['test', 'docs', 'media', '*.html'].map((name) => `./usr/share/emscripten/${name}`),
  ...[
    'lto',
    'pic',
    'thinlto',
    'libSDL*',
    '*-emu*',
    '*full_es3*',
    '*-ofb*',
    '*-ww*',
    '*wasmfs*',
    '*-mt*',
  ].map((name) => `./usr/share/emscripten/cache/sysroot/lib/wasm32-emscripten/${name}`),
  './usr/share/emscripten/cache/sysroot/lib/wasm64-emscripten',
];

// Unpacked to `emsdk/emscripten/copyright`; the notices of the built package quote it.
const licences = './usr/share/doc/emscripten/copyright';

/** Root folder of an Emscripten >= 3.1.60 on the PATH, or null. */
export function emscriptenOnPath() {
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  const program = folders.map((folder) => join(folder, 'em++')).find((file) => existsSync(file));
  if (!program) return null;
  const version = capture(program, ['--version'])?.match(/ (\d+)\.(\d+)\.(\d+)/);
  if (!version) return null;
  const [major, minor, patch] = version.slice(1).map(Number);
  const isNewEnough = major > 3 || (major === 3 && (minor > 1 || (minor === 1 && patch >= 60)));
  const folder = dirname(realpathSync(program));
  return isNewEnough && existsSync(join(folder, cmakePlatform)) ? folder : null;
}

const cmakePlatform = 'cmake/Modules/Platform/Emscripten.cmake';

export function emscripten() {
  const found = emscriptenOnPath();
  if (!found) {
    const what = fingerprint(
      suite,
      toolchain,
      process.execPath,
      ...packages,
      ...unwanted,
      licences,
    );
    once('emscripten', what, installPrivately, [join(toolchain, 'emsdk/em++')]);
  }
  const platform = join(found ?? join(toolchain, 'emsdk'), cmakePlatform);
  once(
    'emscripten-cmake',
    platform,
    () => {
      writeFileSync(join(toolchain, 'emscripten.cmake'), `include("${platform}")\n`);
    },
    [join(toolchain, 'emscripten.cmake')],
  );
}

function installPrivately() {
  const downloads = join(toolchain, 'downloads');
  const runtime = join(toolchain, 'rt');
  const emsdk = join(toolchain, 'emsdk');
  for (const folder of [downloads, runtime, emsdk]) {
    rmSync(folder, { recursive: true, force: true });
    mkdirSync(folder, { recursive: true });
  }
  privateApt('deb', suite)(['download', ...packages], downloads);
  for (const file of readdirSync(downloads)) {
    const archive = join(downloads, file);
    if (file.startsWith('emscripten_')) unpackEmscripten(archive, emsdk);
    else run('dpkg', ['-x', archive, runtime]);
  }
  rmSync(downloads, { recursive: true });

  // Emscripten's `.js` tools are CommonJS; without this they would count as part of our package of ES modules.
  writeFileSync(join(emsdk, 'package.json'), '{ "type": "commonjs" }\n');
  const binaryen = wrapBinaryen(runtime);
  // A link, not NODE_PATH: the tools that need acorn are ES modules.
  const modules = join(emsdk, 'node_modules');
  mkdirSync(modules, { recursive: true });
  rmSync(join(modules, 'acorn'), { recursive: true, force: true });
  symlinkSync(join(runtime, 'usr/share/nodejs/acorn'), join(modules, 'acorn'));
  const config = { LLVM_ROOT: llvm, BINARYEN_ROOT: binaryen, NODE_JS: process.execPath };
  const lines = Object.entries(config).map(([key, value]) => `${key} = ${JSON.stringify(value)}\n`);
  rmSync(join(emsdk, '.emscripten'), { force: true });
  writeFileSync(join(emsdk, '.emscripten'), `${lines.join('')}FROZEN_CACHE = True\n`);
}

function unpackEmscripten(archive, emsdk) {
  const excludes = unwanted.map((pattern) => `--exclude='${pattern}'`).join(' ');
  const unpack = `tar -x -C "$2" --strip-components=4 ${excludes} ./usr/share/emscripten ${licences}`;
  run('bash', [
    '-o',
    'pipefail',
    '-c',
    `dpkg-deb --fsys-tarfile "$1" | ${unpack}`,
    'bash',
    archive,
    emsdk,
  ]);
}

/** The next release's programs need its C library: each is started through that library's own loader. */
function wrapBinaryen(runtime) {
  const libraries = join(runtime, 'usr/lib');
  const triplet = readdirSync(libraries).find((name) => name.endsWith('-linux-gnu'));
  const folder = join(libraries, triplet);
  const loader = join(
    folder,
    readdirSync(folder).find((name) => /^ld-linux.*\.so/.test(name)),
  );
  const home = join(toolchain, 'binaryen');
  mkdirSync(join(home, 'bin'), { recursive: true });
  for (const name of readdirSync(join(runtime, 'usr/bin')).filter((file) =>
    file.startsWith('wasm'),
  )) {
    const wrapper = join(home, 'bin', name);
    const program = join(runtime, 'usr/bin', name);
    writeFileSync(
      wrapper,
      `#!/bin/sh\nexec "${loader}" --library-path "${folder}" "${program}" "$@"\n`,
    );
    chmodSync(wrapper, 0o755);
  }
  return home;
}
