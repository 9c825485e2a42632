/** The package in a page or a worker. */
import { pageLoader } from '../browser/page-assets.js';
import { browserPool } from '../core/browser-pool.js';
import { makeDoor } from './door.js';

export const { open, unfold } = makeDoor({ startPool: browserPool, ...pageLoader });
export { browserPool as startPool, type EngineAddresses } from '../core/browser-pool.js';
export * from './exports.js';
