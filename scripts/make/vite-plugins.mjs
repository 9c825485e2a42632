// Small Vite plugins that both bundles share.
import { createHash } from 'node:crypto';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { root } from '../setup/paths.mjs';

/** Where each bundle notes which npm packages it contains, for the third-party notices. */
export const shippedFolder = join(root, 'build/shipped');

/** @param name of the note, one per plugin; Vite builds each worker as a bundle of its own, all of which may share one */
export function notePackages(name) {
  const noted = new Set();
  return {
    name: 'note-packages',
    generateBundle(_options, bundle) {
      const chunks = Object.values(bundle).filter((file) => file.type === 'chunk');
      const modules = chunks.flatMap((chunk) => Object.keys(chunk.modules));
      // The innermost node_modules folder names the package, scoped or not.
      const packages = modules.map((id) => id.match(/.*node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[0]);
      for (const folder of packages.filter(Boolean)) noted.add(folder);
      mkdirSync(shippedFolder, { recursive: true });
      writeFileSync(join(shippedFolder, `${name}.json`), JSON.stringify([...noted].sort()));
    },
  };
}

/** Puts all WASM beside the scripts, where node looks for it: the engine, and what it, readers and writers load at need. */
export function copyWasm() {
  const files = {
    'foldwright.wasm': 'web/core/generated/foldwright.wasm',
    'manifold.wasm': 'node_modules/manifold-3d/manifold.wasm',
    'draco.wasm': 'node_modules/draco3dgltf/draco_decoder_gltf.wasm',
    'resvg.wasm': 'node_modules/@resvg/resvg-wasm/index_bg.wasm',
    'webp.wasm': 'node_modules/@jsquash/webp/codec/dec/webp_dec.wasm',
  };
  return {
    name: 'copy-wasm',
    generateBundle() {
      for (const [fileName, file] of Object.entries(files)) {
        this.emitFile({ type: 'asset', fileName, source: readFileSync(join(root, file)) });
      }
    },
  };
}

/** Puts the fonts of printed texts into a folder beside the scripts: under node they are read as files. */
export function copyFonts() {
  const wanted = {
    'noto-sans': /^noto-sans-(?!devanagari).*-400-normal\.woff$/,
    'biz-udpgothic': /^biz-udpgothic-\d+-400-normal\.woff$/,
  };
  return {
    name: 'copy-fonts',
    generateBundle() {
      for (const [font, pattern] of Object.entries(wanted)) {
        const folder = join(root, 'node_modules/@fontsource', font, 'files');
        for (const file of readdirSync(folder).filter((name) => pattern.test(name))) {
          const source = readFileSync(join(folder, file));
          this.emitFile({ type: 'asset', fileName: `fonts/${file}`, source });
        }
      }
    },
  };
}

/** Emscripten's modules ask for those of node under node only; browsers get empty ones instead of a warning. */
export function withoutNodeModules() {
  const empty = '\0empty';
  const names = ['module', 'fs', 'path', 'node:fs', 'node:path'];
  return {
    name: 'without-node-modules',
    enforce: 'pre',
    resolveId: (id) => (names.includes(id) ? empty : null),
    load: (id) => (id === empty ? 'export {};' : null),
  };
}

/**
 * A module of the addresses of the gallery's files by their names. Each is named by itself: so those who take up the
 * package find them.
 */
export function sampleAddresses() {
  const name = 'virtual:sample-addresses';
  const own = `\0${name}`;
  return {
    name: 'sample-addresses',
    resolveId: (id) => (id === name ? own : null),
    load(id) {
      if (id !== own) return null;
      const files = readdirSync(join(root, 'web/app/public/samples')).sort();
      const imports = files.map((file, i) => `import at${i} from '/samples/${file}?url';`);
      const entries = files.map((file, i) => `${JSON.stringify(file)}: at${i}`);
      return `${imports.join('\n')}\nexport default { ${entries.join(', ')} };`;
    },
  };
}

/** Names of all files below a folder, with slashes and in order. */
function filesBelow(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => relative(folder, join(parentPath, name)).replaceAll(sep, '/'))
    .sort();
}

/**
 * Builds a service worker beside the page and tells it, as the constant `build`, which files there
 * are in the whole build and a hash of them, which changes whenever one of them does.
 *
 * @param worker path of its source, which imports nothing
 */
export function precache(worker) {
  const fileName = 'service-worker.js';
  return {
    name: 'precache',
    buildStart() {
      this.emitFile({ type: 'chunk', id: worker, fileName });
    },
    // The files that are only copied are there by then.
    writeBundle({ dir }) {
      const names = filesBelow(dir).filter((name) => name !== fileName);
      const hash = createHash('sha256');
      for (const name of [fileName, ...names])
        hash.update(name).update(readFileSync(join(dir, name)));
      // Hosts may send the page's own name elsewhere; what it is found by is its folder.
      const files = names.map((name) => (name === 'index.html' ? './' : name));
      const build = JSON.stringify({ hash: hash.digest('hex').slice(0, 16), files });
      const script = readFileSync(join(dir, fileName), 'utf8');
      writeFileSync(join(dir, fileName), `const build=${build};\n${script}`);
    },
  };
}

/**
 * Writes `integrity.json` beside the bundle: the hash of each of its files by its name, in the form of the part of an
 * import map that browsers check modules by (Subresource Integrity).
 */
export function integrity() {
  const fileName = 'integrity.json';
  return {
    name: 'integrity',
    // After those who change files once they are written.
    enforce: 'post',
    writeBundle({ dir }) {
      const hashes = filesBelow(dir)
        .filter((name) => name !== fileName)
        .map((name) => {
          const hash = createHash('sha384').update(readFileSync(join(dir, name)));
          return [`./${name}`, `sha384-${hash.digest('base64')}`];
        });
      const map = { integrity: Object.fromEntries(hashes) };
      writeFileSync(join(dir, fileName), `${JSON.stringify(map, null, 2)}\n`);
    },
  };
}
