// Folders are layers: fails when a file includes or imports from a folder that its own may not know, or in a circle.
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { sourceFiles } from './files.mjs';
import { root } from './setup/paths.mjs';

const unfold = ['unfold', 'mesh', 'geometry'];
const engine = [
  ...['pipeline', 'segment', 'search', 'paper', 'fold', 'read', 'repair', 'simplify'],
  ...unfold,
];
const web = ['view', 'project', 'export', 'core', 'read', 'browser', 'words', 'model'];

/** What each folder may know besides itself. */
const mayKnow = {
  'cpp/geometry': [],
  'cpp/mesh': ['geometry'],
  'cpp/read': ['mesh', 'geometry'],
  'cpp/repair': ['mesh', 'geometry'],
  'cpp/simplify': ['mesh', 'geometry'],
  'cpp/unfold': ['mesh', 'geometry'],
  'cpp/fold': unfold,
  'cpp/segment': unfold,
  'cpp/paper': unfold,
  'cpp/search': ['fold', ...unfold],
  'cpp/pipeline/values': engine.slice(1),
  'cpp/pipeline': ['pipeline/values', ...engine.slice(1)],
  bindings: ['pipeline/values', ...engine.filter((folder) => folder !== 'read')],
  'web/model': [],
  'web/words': ['model'],
  'web/browser': [],
  'web/read': ['words', 'model'],
  'web/core': ['read', 'browser', 'words', 'model'],
  'web/view': ['browser', 'model'],
  'web/export': ['words', 'model'],
  'web/pwa': ['model'],
  'web/project': ['export', 'read', 'words', 'model'],
  'web/api': ['project', 'export', 'core', 'read', 'browser', 'words', 'model'],
  'web/cli': ['api', 'project', 'export', 'core', 'read', 'words', 'model'],
  'web/app': ['api', 'pwa', ...web],
  'web/element': ['api', 'app', ...web],
};

/** Folders within a layer are no layers, but for the values that all of the pipeline hands on. */
const layerOf = (path) =>
  path.match(/^cpp\/pipeline\/values(?=\/)|^(?:cpp|web)\/[^/]+(?=\/)|^bindings(?=\/)/)?.[0];

/** `#include "mesh/mesh.h"` counts from cpp/, or else from the file's own folder. */
function includes(path, text) {
  return [...text.matchAll(/^\s*#\s*include\s+"([^"]+)"/gm)].map(([, name]) => {
    const fromRoot = join('cpp', name);
    return existsSync(join(root, fromRoot)) ? fromRoot : normalize(join(dirname(path), name));
  });
}

/** Static and dynamic imports, re-exports, and workers and assets named by `new URL`, of relative paths. */
function imports(path, text) {
  const pattern = /(?:\bfrom\s*|\bimport\s*\(?\s*|\bnew URL\(\s*)['"](\.{1,2}\/[^'"?]+)/g;
  return [...text.matchAll(pattern)].map(([, name]) => {
    const target = normalize(join(dirname(path), name));
    const candidates = [
      target,
      `${target}.ts`,
      target.replace(/\.m?js$/, '.ts'),
      join(target, 'index.ts'),
    ];
    return candidates.find((file) => /\.\w+$/.test(file) && existsSync(join(root, file))) ?? target;
  });
}

function dependencies() {
  const graph = new Map();
  const read = (path) => readFileSync(join(root, path), 'utf8');
  for (const path of sourceFiles(['cpp', 'bindings'], ['.h', '.cpp']))
    graph.set(path, includes(path, read(path)));
  for (const path of sourceFiles(['web'], ['.ts', '.tsx', '.mjs']))
    graph.set(path, imports(path, read(path)));
  return graph;
}

function upwardImports(graph) {
  const faults = [];
  for (const [path, targets] of graph) {
    const layer = layerOf(path);
    if (layer && !(layer in mayKnow))
      faults.push(`${path}: ${layer} has no place among the layers`);
    for (const target of targets) {
      const other = layerOf(target);
      if (!layer || !other || other === layer) continue;
      if (!mayKnow[layer]?.includes(other.replace(/^(cpp|web)\//, ''))) {
        faults.push(`${path}: ${layer} must not know ${other} (${target})`);
      }
    }
  }
  return faults;
}

function circles(graph) {
  const faults = [];
  const state = new Map(); // 'open' while on the trail, 'done' after
  const visit = (path, trail) => {
    if (state.get(path) === 'done' || !graph.has(path)) return;
    if (state.get(path) === 'open') {
      faults.push(`circle: ${[...trail.slice(trail.indexOf(path)), path].join(' -> ')}`);
      return;
    }
    state.set(path, 'open');
    for (const target of graph.get(path)) visit(target, [...trail, path]);
    state.set(path, 'done');
  };
  for (const path of graph.keys()) visit(path, []);
  return faults;
}

const graph = dependencies();
const faults = [...upwardImports(graph), ...circles(graph)];
for (const fault of faults) console.error(fault);
console.log(`layers: ${graph.size} files, ${faults.length} faults`);
process.exit(faults.length === 0 ? 0 : 1);
