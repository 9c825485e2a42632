// The Debian packages that building and testing need. Only what is missing is installed.
import { existsSync, readFileSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { operatingSystem } from './apt-sources.mjs';
import { emscriptenOnPath } from './emscripten.mjs';
import { run, SetupError } from './shell.mjs';

const engine = [
  ...['cmake', 'ninja-build', 'g++', 'dpkg-dev', 'python3', 'xz-utils'],
  ...['libeigen3-dev', 'libspectra-dev', 'libgtest-dev', 'libbenchmark-dev'],
];
const emscriptenNeeds = ['clang-19', 'lld-19', 'llvm-19'];
// Three whole browsers, and a screen for them.
const engines = ['chromium', 'firefox-esr', 'webkit2gtk-driver', 'xvfb'];
// A browser without windows, tools that judge the written PDF and SVG files, the formatter of C++, and libFuzzer with the
// compiler that it belongs to.
const testing = [
  ...['chromium-headless-shell', 'poppler-utils', 'qpdf', 'librsvg2-bin'],
  ...['clang-format', 'clang-tidy'],
  ...['clang-19', 'libclang-rt-19-dev'],
];

/**
 * @param withBrowser also what only the tests need
 * @param withEngines also what only the tests in three engines need
 */
export function debianPackages({ withBrowser, withEngines }) {
  if (operatingSystem().id !== 'debian') return requireTools({ withBrowser, withEngines });
  const wanted = [
    ...engine,
    ...(emscriptenOnPath() ? [] : emscriptenNeeds),
    ...(withBrowser ? testing : []),
    ...(withEngines ? engines : []),
  ];
  const present = installedPackages();
  const missing = wanted.filter((name) => !present.has(name));
  if (missing.length === 0) return;
  const install = [
    '-o',
    'DPkg::Lock::Timeout=500',
    'install',
    '-y',
    '--no-install-recommends',
    ...missing,
  ];
  if (process.getuid() !== 0) {
    throw new SetupError(
      `packages are missing; install them, then start again:\n\n` +
        `  sudo apt-get update && sudo apt-get ${install.join(' ')}\n`,
    );
  }
  console.log(`installing ${missing.join(' ')}`);
  const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' };
  run('apt-get', ['-q', '-o', 'DPkg::Lock::Timeout=500', 'update'], { env });
  run('apt-get', ['-q', ...install], { env });
}

/** Names of the installed packages, read from dpkg's own record: asking dpkg takes longer than all other checks. */
function installedPackages(file = '/var/lib/dpkg/status') {
  const names = new Set();
  for (const stanza of readFileSync(file, 'utf8').split('\n\n')) {
    const name = stanza.match(/^Package: (.+)$/m)?.[1];
    if (name && /^Status: \S+ \S+ installed$/m.test(stanza)) names.add(name);
  }
  return names;
}

/** On other systems nothing is installed: what is missing is named, and a person chooses where it comes from. */
function requireTools({ withBrowser, withEngines }) {
  const programs = [
    'cmake',
    'ninja',
    ...(withBrowser ? ['clang-format', 'clang++-19', 'qpdf', 'pdftocairo', 'chromium'] : []),
    ...(withEngines ? ['firefox-esr', 'WebKitWebDriver', 'Xvfb'] : []),
  ];
  const missing = programs.filter((name) => !isOnPath(name));
  if (!emscriptenOnPath()) missing.push('em++ (Emscripten 3.1.60 or newer)');
  if (missing.length === 0) return;
  throw new SetupError(
    `this is not a Debian system, so nothing is installed by itself. Missing: ${missing.join(', ')}.\n` +
      'Wanted besides: a C++20 compiler, Eigen 3.4, Spectra 1.0, GoogleTest and Google Benchmark.',
  );
}

function isOnPath(name) {
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  return folders.some((folder) => existsSync(join(folder, name)));
}
