// Bundles the scripts of the demonstrations, which draw with the studio's own pictures; the engine is loaded by them from
// the studio's folder of the site.
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { buildSync } from 'esbuild';
import { root } from '../../scripts/setup/paths.mjs';

const outdir = join(root, 'build/site/demos');

rmSync(outdir, { recursive: true, force: true });
buildSync({
  entryPoints: [join(root, 'site/demos/demos.ts')],
  bundle: true,
  format: 'esm',
  minify: true,
  target: ['chrome95', 'firefox114', 'safari16.4'],
  outdir,
  logLevel: 'warning',
});
