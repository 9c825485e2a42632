/** The package in a page or a worker. */
import { loadFont } from '../browser/font-loader.js';
import { loadRenderer } from '../browser/renderer-loader.js';
import { browserPool } from '../core/browser-pool.js';
import { makeDoor } from './door.js';

export const { open, unfold } = makeDoor({ startPool: browserPool, loadFont, loadRenderer });
export { browserPool as startPool, type EngineAddresses } from '../core/browser-pool.js';
export * from './exports.js';
