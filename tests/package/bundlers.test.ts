/** The package in projects that other people's tools bundle. What each needs is told in `docs/package.md`. */
import { cp, mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { build as buildByEsbuild } from 'esbuild';
import { build as buildByVite, createServer } from 'vite';
import { expect, test } from 'vitest';
import webpack from 'webpack';
import { inFolder } from '../web/command.js';
import { install } from '../web/packed.js';
import { checkFolder, checkPage, html, script, writeModel } from './bundled-page.js';

/** An empty project with the package and the page's script. */
function inProject(work: (folder: string) => Promise<void>): Promise<void> {
  return inFolder(async (folder) => {
    await install(folder);
    await mkdir(join(folder, 'src'));
    await writeFile(join(folder, 'src/main.js'), script);
    await work(folder);
  });
}

test('Vite bundles it', () =>
  inProject(async (root) => {
    await writeFile(join(root, 'index.html'), html('/src/main.js'));
    await buildByVite({ root, configFile: false, logLevel: 'warn', build: { target: 'es2022' } });
    await checkFolder(join(root, 'dist'));
  }));

test("Vite's server serves it", () =>
  inProject(async (root) => {
    await writeFile(join(root, 'index.html'), html('/src/main.js'));
    await mkdir(join(root, 'public'));
    await writeModel(join(root, 'public'));
    const optimizeDeps = { exclude: ['foldwright'] };
    const server = await createServer({ root, configFile: false, logLevel: 'warn', optimizeDeps });
    try {
      await server.listen();
      await checkPage(server.resolvedUrls!.local[0]!);
    } finally {
      await server.close();
    }
  }));

function bundleByWebpack(context: string, entry: string): Promise<webpack.Stats> {
  const output = { path: join(context, 'dist') };
  return new Promise((resolve, reject) => {
    webpack({ context, entry, output, mode: 'production' }, (error, stats) => {
      if (error || !stats) return reject(error ?? new Error('webpack said nothing'));
      resolve(stats);
    });
  });
}

test('webpack bundles it', () =>
  inProject(async (root) => {
    const stats = await bundleByWebpack(root, './src/main.js');
    expect(stats.toJson({ errors: true }).errors).toEqual([]);
    await writeFile(join(root, 'dist/index.html'), html());
    await checkFolder(join(root, 'dist'));
  }));

test.each([false, true])('esbuild bundles it, with its assets beside; in chunks: %s', (splitting) =>
  inProject(async (root) => {
    await buildByEsbuild({
      absWorkingDir: root,
      entryPoints: ['src/main.js'],
      outdir: 'dist',
      bundle: true,
      format: 'esm',
      target: 'es2022',
      logLevel: 'warning',
      splitting,
    });
    const built = join(root, 'node_modules/foldwright/dist/package');
    for (const folder of ['assets', 'samples']) {
      await cp(join(built, folder), join(root, 'dist', folder), { recursive: true });
    }
    await writeFile(join(root, 'dist/index.html'), html());
    await checkFolder(join(root, 'dist'));
  }),
);

test('only the scripts of the elements are bundled when nothing of them is called', () =>
  inFolder(async (root) => {
    await install(root);
    const sizes = ['foldwright', 'foldwright/viewer', 'foldwright/studio'].map(async (name) => {
      const stdin = { contents: `import '${name}';`, resolveDir: root };
      const options = { bundle: true, format: 'esm', write: false, logLevel: 'error' } as const;
      const { outputFiles } = await buildByEsbuild({ ...options, stdin });
      return outputFiles[0]!.contents.length;
    });
    const [engine, viewer, studio] = await Promise.all(sizes);
    expect(engine).toBe(0);
    expect(viewer).toBeGreaterThan(1000);
    expect(studio).toBeGreaterThan(1000);
  }));

test('a page without a bundler imports its scripts', () =>
  inProject(async (root) => {
    const built = join(root, 'node_modules/foldwright/dist/studio');
    await cp(built, join(root, 'site/foldwright'), { recursive: true });
    const plain = script
      .replace("'foldwright'", "'./foldwright/foldwright.js'")
      .replace(/'foldwright\/(\w+)'/g, "'./foldwright/foldwright-$1.js'");
    await writeFile(join(root, 'site/main.js'), plain);
    await writeFile(join(root, 'site/index.html'), html());
    await checkFolder(join(root, 'site'));
  }));
