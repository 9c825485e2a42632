// Modules of web/ as they are, for programs that node runs: TypeScript is bundled in memory.
import { build } from 'esbuild';
import { root } from '../../scripts/setup/paths.mjs';

/** @param {string} entry exports of modules below the root, as TypeScript @returns {Promise<any>} what it exports */
export async function fromSources(entry) {
  const { outputFiles } = await build({
    stdin: { contents: entry, resolveDir: root, loader: 'ts' },
    bundle: true,
    format: 'esm',
    platform: 'node',
    write: false,
  });
  const code = Buffer.from(outputFiles[0].contents).toString('base64');
  return import(`data:text/javascript;base64,${code}`);
}
