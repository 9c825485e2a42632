/** The package under node. */
import { nodePool } from '../core/node-pool.js';
import { makeDoor } from './door.js';
import { readFontFile } from './node-fonts.js';
import { readRendererFile } from './node-renderer.js';

export const { open, unfold } = makeDoor({
  startPool: nodePool,
  loadFont: readFontFile,
  loadRenderer: readRendererFile,
});
export { nodePool as startPool, type EngineAddresses } from '../core/node-pool.js';
export * from './exports.js';
