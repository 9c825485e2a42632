import { join } from 'node:path';
import { build } from './make/index.mjs';
import { serve } from './serve.mjs';
import { root } from './setup/paths.mjs';
import { main } from './setup/shell.mjs';

const firstPort = 5173; // where Vite's users look

await main(build);
const { address } = await serve(join(root, 'dist/studio'), {
  port: firstPort,
  compress: true,
});
console.log(`Foldwright is at ${address} (Ctrl+C ends it)`);
